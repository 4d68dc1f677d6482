/* Component ${head.model}. */
#ifndef ${head.prefix}${head.name}_h
#define ${head.prefix}${head.name}_h
<#list head.mentions as type>
#include "${type.prefix}${type.name}.h"
</#list>

typedef struct {
<#list head.inputs + head.outputs as port>
    ${port.type} ${port.name}; /* ${port.comment} */
<#if port.flag != "">
    int ${port.flag};
</#if>
</#list>
<#list variables as variable>
    ${variable.type} ${variable.name};
</#list>
    int ${state};
    int ${taken};
} ${head.prefix}${head.name};

void ${head.prefix}${head.name}_start(${head.prefix}${head.name} *self);
void ${head.prefix}${head.name}_step(${head.prefix}${head.name} *self);
#endif
