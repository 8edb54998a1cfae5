#define ${name}_WIDTH $width
#define ${name}_HEIGHT $height
static const size_t ${name}_VARIABLES[${name}_WIDTH] = {$variables};
static const size_t ${name}_ROWS[${name}_HEIGHT] = {$rows};
