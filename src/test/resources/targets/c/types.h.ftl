/* Messages of type ${model}; 0 is no message. */
#ifndef ${prefix}${name}_h
#define ${prefix}${name}_h
enum {
<#list constants as constant>
    ${prefix}${name}_${constant.code} = ${constant.number}<#sep>,</#sep>
</#list>
};
#endif
