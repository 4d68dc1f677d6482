<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.imports head/>
/** Component ${head.model}. */
public final class ${head.name} {
<@parts.ports head/>
<#list members as part>
    public final ${part.type} ${part.name};
</#list>

    public ${head.name}(<@parts.parameters head/>) {
<#list members as part>
        ${part.name} = new ${part.type}(${part.arguments});
</#list>
<#list fixed as assignment>
        ${assignment.target} = ${assignment.value};
</#list>
<#list registers as assignment>
        ${assignment.target} = ${assignment.value};
</#list>
    }
<#if sensors?has_content>

    /** Samples the sensors: the start of a slice. */
    public void sense() {
<#list sensors as sensor>
        ${sensor}.sense();
</#list>
<#list sensed as assignment>
        ${assignment.target} = ${assignment.value};
</#list>
    }
</#if>

    /** Performs one slice. */
    public void step() {
<#if known?has_content>
        // Known when the slice starts: from outside, from sensors, and sent in the slice before.
<#list known as assignment>
        ${assignment.target} = ${assignment.value};
</#list>

</#if>
<#list steps as step>
<#list step.copies as assignment>
        ${assignment.target} = ${assignment.value};
</#list>
<#if step.call != "">
        ${step.part}.${step.call}();
</#if>
</#list>
<#if registers?has_content || fresh?has_content>

</#if>
<#list fresh + registers as assignment>
        ${assignment.target} = ${assignment.value};
</#list>
    }
}
