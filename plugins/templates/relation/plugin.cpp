#include <gestalt/core/plugin/plugin.h>

#include "my_component.h"

GESTALT_PLUGIN(gestalt::component<MyComponent>("my_component", "0.1.0",
                                               "r_my_component: difference of mean brightness"))
