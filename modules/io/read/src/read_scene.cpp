// Only with PCL_SYMMETRY_WITH_ASSIMP; see readers.h.
#include "io/read/readers.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

namespace pcl {
namespace symmetry {
namespace {

/** \brief No files: a scene may name others, anywhere on the machine. */
class NoFiles : public Assimp::IOSystem {
public:
  bool
  Exists(const char* /*path*/) const override
  {
    return false;
  }

  char
  getOsSeparator() const override
  {
    return '/';
  }

  Assimp::IOStream*
  Open(const char* /*path*/, const char* /*mode*/) override
  {
    return nullptr;
  }

  void
  Close(Assimp::IOStream* /*stream*/) override
  {
  }
};

/** \brief Puts the meshes of a scene together, in the order in which its nodes name them. */
class SceneSurface {
public:
  SceneSurface(const FileContent& file, const aiScene& scene, const std::array<double, 3>& origin)
      : file_(file), scene_(scene), origin_(origin)
  {
  }

  Surface
  take()
  {
    addNode(*scene_.mRootNode, aiMatrix4x4(), 0);
    if (surface_.normals.size() != surface_.size())
      surface_.normals.clear();
    return std::move(surface_);
  }

private:
  void
  addNode(const aiNode& node, const aiMatrix4x4& above, int depth)
  {
    constexpr int deepest = 1000; // of the nodes of a tree that somebody made; more are a trap for the stack
    if (depth > deepest)
      file_.fail("holds nodes nested deeper than " + std::to_string(deepest));
    const aiMatrix4x4 place = above * node.mTransformation;
    const aiMesh* before = nullptr;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
      if (before == nullptr || !hasPointsOf(*before, mesh))
        addPoints(mesh, place);
      addFaces(mesh);
      before = &mesh;
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      addNode(*node.mChildren[i], place, depth + 1);
  }

  /** \brief Whether two parts of a mesh share their points, as glTF's do that differ in material; assimp gives each all
   * of them. */
  static bool
  hasPointsOf(const aiMesh& a, const aiMesh& b)
  {
    return a.mNumVertices == b.mNumVertices && std::equal(a.mVertices, a.mVertices + a.mNumVertices, b.mVertices);
  }

  void
  addPoints(const aiMesh& mesh, const aiMatrix4x4& place)
  {
    first_ = surface_.size();
    if (first_ + mesh.mNumVertices > point_limit)
      file_.fail("holds more points than can be numbered");
    const aiMatrix3x3 turn(place);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D p = place * mesh.mVertices[i];
      surface_.points.push_back({static_cast<float>(double{p.x} - origin_[0]),
                                 static_cast<float>(double{p.y} - origin_[1]),
                                 static_cast<float>(double{p.z} - origin_[2])});
      if (mesh.HasNormals()) {
        const aiVector3D n = turn * mesh.mNormals[i];
        surface_.normals.push_back({n.x, n.y, n.z});
      }
    }
  }

  void
  addFaces(const aiMesh& mesh)
  {
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      corners_.clear();
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        if (face.mIndices[k] >= mesh.mNumVertices)
          file_.fail("a face refers to point " + std::to_string(face.mIndices[k]) + " of " +
                     std::to_string(mesh.mNumVertices));
        corners_.push_back(static_cast<Index>(first_ + face.mIndices[k]));
      }
      appendPolygon(corners_, surface_.triangles);
    }
  }

  const FileContent& file_;
  const aiScene& scene_;
  const std::array<double, 3>& origin_;
  Surface surface_;
  std::vector<Index> corners_;
  std::size_t first_ = 0; ///< number of the first point of the mesh
};

} // namespace

Surface
readScene(const FileContent& file, const std::string& ending, Reading& reading)
{
  Assimp::Importer importer;
  importer.SetIOHandler(new NoFiles()); // the importer's own from here on
  // Without any step of assimp's that joins, sorts or splits: points keep their numbers.
  const aiScene* const scene = importer.ReadFileFromMemory(file.data(), file.size(), 0, ending.substr(1).c_str());
  if (scene == nullptr || scene->mRootNode == nullptr)
    file.fail("assimp cannot read it: " + quoted(importer.GetErrorString()));
  reading.single_precision = true;
  return SceneSurface(file, *scene, reading.origin).take();
}

} // namespace symmetry
} // namespace pcl
