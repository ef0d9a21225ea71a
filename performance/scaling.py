"""Parts of scaling.sh: runs the program once, sums up runs, fits and draws how time grows with the number of vertices."""
import json
import math
import resource
import statistics
import subprocess
import sys


def run(report, *command):
    """Runs the program; its report gets the peak memory in MB as well."""
    subprocess.run([*command, "--report", report], check=True, stdout=subprocess.DEVNULL)
    with open(report) as file:
        result = json.load(file)
    result["peak"] = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    with open(report, "w") as file:
        json.dump(result, file)


def row(vertices, *names):
    """Prints the medians of several runs on one surface."""
    reports = [json.load(open(name)) for name in names]
    steps = {s: statistics.median(r["seconds"].get(s, 0) for r in reports) for s in reports[0]["seconds"]}
    work = statistics.median(
        r["seconds"]["total"] - r["seconds"].get("read", 0) - r["seconds"].get("write", 0) for r in reports)
    peak = statistics.median(r["peak"] for r in reports)
    print(f"{int(vertices):7d} vertices  {work:6.3f} s without reading and writing  {peak:4.0f} MB  "
          + "  ".join(f"{name} {seconds:.3f}" for name, seconds in steps.items() if name != "total"))


def exponent(points):
    """Slope of the straight line nearest to the points (vertices, seconds) in logarithms."""
    x = [math.log(vertices) for vertices, _ in points]
    y = [math.log(seconds) for _, seconds in points]
    mean_x, mean_y = statistics.mean(x), statistics.mean(y)
    return (sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x))


def plot(points, slope):
    """A picture of the points on logarithmic axes, with a line of exponent 1 through the last one."""
    width, height, margin = 560, 400, 60
    decades_x = (math.floor(math.log10(points[0][0])), math.ceil(math.log10(points[-1][0])))
    lowest = min(seconds for _, seconds in points)
    decades_y = (math.floor(math.log10(lowest)), math.ceil(math.log10(max(seconds for _, seconds in points))))

    def place(vertices, seconds):
        x = (math.log10(vertices) - decades_x[0]) / (decades_x[1] - decades_x[0])
        y = (math.log10(seconds) - decades_y[0]) / (decades_y[1] - decades_y[0])
        return margin + x * (width - 2 * margin), height - margin - y * (height - 2 * margin)

    def line(ends, style):
        return '<polyline fill="none" %s points="%s"/>' % (style, " ".join("%.1f,%.1f" % place(*p) for p in ends))

    def text(x, y, words, anchor="middle"):
        return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{words}</text>'

    low, high = 10.0 ** decades_y[0], 10.0 ** decades_y[1]
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" '
             'font-size="12">', f'<rect width="{width}" height="{height}" fill="white"/>']
    for decade in range(decades_x[0], decades_x[1] + 1):
        parts.append(line([(10.0 ** decade, low), (10.0 ** decade, high)], 'stroke="#ccc"'))
        parts.append(text(place(10.0 ** decade, low)[0], height - margin + 18, f"{10 ** decade:,}"))
    for decade in range(decades_y[0], decades_y[1] + 1):
        y = place(10.0 ** decades_x[0], 10.0 ** decade)[1]
        parts.append(line([(10.0 ** decades_x[0], 10.0 ** decade), (10.0 ** decades_x[1], 10.0 ** decade)], 'stroke="#ccc"'))
        parts.append(text(margin - 8, y + 4, f"{10.0 ** decade:g} s", "end"))
    last_vertices, last_seconds = points[-1]
    first = max(points[0][0], last_vertices * low / last_seconds)
    parts.append(line([(first, last_seconds * first / last_vertices), points[-1]], 'stroke="#999" stroke-dasharray="5 4"'))
    parts.append(line(points, 'stroke="#1f5fa8" stroke-width="2"'))
    parts += ['<circle cx="%.1f" cy="%.1f" r="3.5" fill="#1f5fa8"/>' % place(*p) for p in points]
    parts.append(text(width / 2, margin - 28, f"time without reading and writing: exponent {slope:.2f} (dashed: 1)"))
    parts.append(text(width / 2, height - 14, "vertices"))
    return "\n".join([*parts, "</svg>", ""])


def fit(rows, picture=None):
    """Prints the exponent over all rows; draws them where a file is named."""
    points = []
    with open(rows) as file:
        for words in map(str.split, file):
            points.append((int(words[0]), float(words[2])))
    slope = exponent(points)
    print(f"time grows with the number of vertices to the power of {slope:.2f}")
    if picture:
        with open(picture, "w") as file:
            file.write(plot(points, slope))


if __name__ == "__main__":
    {"run": run, "row": row, "fit": fit}[sys.argv[1]](*sys.argv[2:])
