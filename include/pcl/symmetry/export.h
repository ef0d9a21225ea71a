/** \file
 * \brief Visibility of what the shared libraries export; everything else is hidden.
 */
#pragma once

#define PCL_SYMMETRY_EXPORTS __attribute__((visibility("default")))
