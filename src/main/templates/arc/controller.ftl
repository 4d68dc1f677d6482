<#if packageName?has_content>
package ${packageName};

</#if>
<#list imports as import>
import ${import};
</#list>
<#if imports?has_content>

</#if>
/**
<#list remarks as remark>
 * ${remark}
</#list>
 */
<#if stereotypes?has_content>
${stereotypes}
</#if>
component ${name}<#if refines?has_content> refines ${refines}</#if> {
<#if timing?has_content>
    timing ${timing};

</#if>
    port
<#list ports as port>
        ${port}<#sep>,</#sep><#if !port?has_next>;</#if>
</#list>

    <<completion = "${completion}">> automaton {
        state ${states?join(", ")};

        initial ${initial};
<#list groups as group>

<#list group as transition>
        ${transition};
</#list>
</#list>
    }
}
