/** \file
 * \brief Visibility of what the shared libraries export; everything else is hidden.
 */
#pragma once

/** \brief Marks a function or class that the shared libraries export. */
#define PCL_SYMMETRY_EXPORTS __attribute__((visibility("default")))
