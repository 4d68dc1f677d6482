/* Reads slices from the standard input, each the presence and message of every input. */
#include <stdio.h>
#include "${head.prefix}${head.name}.h"

<#macro show port>
<#if port.kind == "enum">
        printf("%d ", self.${port.name});
<#elseif port.flag != "">
        printf(self.${port.flag} ? "%d " : "- ", self.${port.name});
<#else>
        printf("%d ", self.${port.name});
</#if>
</#macro>
int main(void) {
    ${head.prefix}${head.name} self = {0};
    int present;
    int message;
    ${head.prefix}${head.name}_start(&self);
    for (;;) {
<#list head.inputs as input>
        if (scanf("%d %d", &present, &message) != 2) {
            return 0;
        }
<#if input.flag != "">
        self.${input.flag} = present;
</#if>
        self.${input.name} = message;
</#list>
<#list head.outputs?filter(o -> o.delay == 1) as output>
<@show output/>
</#list>
        ${head.prefix}${head.name}_step(&self);
<#list head.outputs?filter(o -> o.delay == 0) as output>
<@show output/>
</#list>
        printf("%d\n", self.state);
    }
}
