#include "${head.prefix}${head.name}.h"

<#list states as name>
#define ${name.constant} ${name.code}
</#list>

void ${head.prefix}${head.name}_start(${head.prefix}${head.name} *self) {
<#list variables as variable>
    self->${variable.name} = ${variable.initial};
</#list>
<#list initials as initial>
<#list initial.assignments as assignment>
    ${assignment.target} = ${assignment.value};
</#list>
    self->${state} = ${initial.target};
</#list>
}

void ${head.prefix}${head.name}_step(${head.prefix}${head.name} *self) {
<#list silences as assignment>
    ${assignment.target} = ${assignment.value};
</#list>
    switch (self->${state}) {
<#list sections as section>
<#list section.states as some>
    case ${some.label}:
<#list some.transitions as transition>
        /* ${transition.comment} */
        if (${(transition.condition == "")?then("1", transition.condition)}) {
<#list transition.locals as local>
            ${local.type} ${local.name} = ${local.initial};
</#list>
<#list transition.assignments as assignment>
            ${assignment.target} = ${assignment.value};
</#list>
<#if transition.target != "">
            self->${state} = ${transition.target};
</#if>
            self->${taken} = ${transition.index};
            return;
        }
</#list>
        break;
</#list>
</#list>
    }
<#list completion.assignments as assignment>
    ${assignment.target} = ${assignment.value};
</#list>
    self->${taken} = -1;
}
