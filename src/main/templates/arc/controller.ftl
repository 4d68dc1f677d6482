<#function block before items><#return items?has_content?then(before + "{" + items?join(", ") + "}", "")></#function>
<#function stereotypes port>
<#local words = port.total?then(["total"], []) + (port.instant && !instant)?then(["delay = \"0\""], [])>
<#return words?has_content?then("<<" + words?join(", ") + ">> ", "")>
</#function>
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
<#if layer != "">
<<layer = "${layer}">>
</#if>
component ${name}<#if refines?has_content> refines ${refines?join(", ")}</#if> {
<#if instant>
    timing instant;

</#if>
    port
<#list ports as port>
        ${stereotypes(port)}${port.input?then("in", "out")} ${port.type} ${port.name}<#sep>,</#sep><#if !port?has_next>;</#if>
</#list>

<#list written as text>
    ${text}

</#list>
<#if !written?has_content>
    <<completion = "${completion}">> automaton {
        state ${states?join(", ")};

        initial ${initial}${block(" / ", sends)};
<#list groups as group>

<#list group as transition>
        ${transition.source}<#if transition.target != ""> -> ${transition.target}</#if><#if transition.guard != ""> [${transition.guard}]</#if>${block(" ", transition.items)}${block(" / ", transition.sends)};
</#list>
</#list>
    }
</#if>
}
