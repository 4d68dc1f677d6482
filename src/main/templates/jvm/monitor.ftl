<#import "parts.ftl" as parts>
<#macro go way indent>
<#if way.comment != "">
${indent}// ${way.comment}
</#if>
<#if way.checked>
${indent}risk();
</#if>
<#if way.condition != "">
${indent}if (${way.condition}) {
${indent}    go(${way.cause}, ${way.target});
<@different way indent + "    "/>
<#if way.alone>
<#if way.checked>
${indent}    unlessWrong();
</#if>
${indent}    break;
</#if>
${indent}}
<#else>
${indent}go(${way.cause}, ${way.target});
<@different way indent/>
</#if>
<#if way.checked>
${indent}unlessWrong();
</#if>
</#macro>
<#macro different way indent>
<#list way.values as value>
${indent}set(${value.variable}, ${value.value});
</#list>
<#list way.promises as promise>
<#if promise.any>
${indent}sendAny(${promise.port});
<#elseif promise.open>
${indent}leaveOpen(${promise.port});
</#if>
<#list promise.messages as message>
${indent}send(${promise.port}, ${message});
</#list>
</#list>
</#macro>
<#macro cases section>
<#list section.variables as variable>
        ${variable.type} ${variable.name} = ${variable.initial};
</#list>
        switch (${state}) {
<#list section.states as some>
            case ${some.label}:<#if !states?has_content> // ${some.name}</#if>
<#list some.transitions as transition>
<@go transition "                "/>
</#list>
                break;

</#list>
            default:
                break;
        }
</#macro>
<@parts.header head/>
<#list imports as type>
import ${type};
</#list>
<#if imports?has_content>

</#if>
/**
 * Watches what component ${title} receives and sends.
 *
<#if events?has_content>
 * <p>Put the {@link #border} into what is watched. Call {@link #slice} after that has started, and
 * after each event, with the message of the event on its port; {@link #violation} says what was
 * not allowed.
<#else>
 * <p>Set the ports to what a slice shows, then call {@link #slice}; {@link #violation} says what
 * was not allowed.
</#if>
 */
public final class ${head.name} extends arcomat.rt.<#if events?has_content>EventMonitor<#else>Monitor</#if> {
<#list states as name>
    private static final int ${name.constant} = ${name.code};
</#list>
<#if states?has_content>

</#if>
<#if events?has_content>
<@parts.inputs head/>
<#else>
<@parts.ports head/>
</#if>
<#list head.parameters as parameter>
    private final ${parameter.type} ${parameter.name};
</#list>
<#list constants as constant>
<#if constant.initial != "">
    private static final ${constant.type} ${constant.name} = ${constant.initial};
<#else>
    private final ${constant.type} ${constant.name};
</#if>
</#list>
<#if head.parameters?has_content || constants?has_content>

</#if>
    public ${head.name}(<@parts.parameters head/>) {
        super(
                ${requirement},
                new String[] {<#list stateNames as name>${name}<#sep>, </#list>},
                ${variables?size},
                new String[] {<#list outputs as output>${output.literal}<#sep>, </#list>}<#if events?has_content>);<#else>,
                new boolean[] {<#list outputs as output>${output.delayed?c}<#sep>, </#list>});</#if>
<#list head.parameters as parameter>
        this.${parameter.name} = ${parameter.name};
</#list>
<#list constructed as assignment>
        ${assignment.target} = ${assignment.value};
</#list>
<#list variables as variable>
        ${variable.type} ${variable.name} = ${variable.initial};
</#list>
<#list initials as initial>
<@go initial "        "/>
</#list>
    }

<#list events as event>
    @Override
    protected boolean hasEvent() {
        return ${event.present};
    }
<#else>
    @Override
    protected void see() {
<#list outputs as output>
<#if output.present != "">
        if (${output.present}) {
            show(${output?index}, ${output.message});
        }
<#else>
        show(${output?index}, ${output.message});
</#if>
</#list>
    }
</#list>
<#if spelt?has_content>

    @Override
    protected String text(int port, long message) {
        switch (port) {
<#list spelt as output>
            case ${output.port}:
                return ${output.text};
</#list>
            default:
                return super.text(port, message);
        }
    }
</#if>

    @Override
    protected void react(int ${state}) {
<#if sections?size == 1>
<@cases sections?first/>
<#else>
<#list sections as section>
        ${section.method}(${state});
</#list>
</#if>
    }
<#if sections?size != 1>
<#list sections as section>

    private void ${section.method}(int ${state}) {
<@cases section/>
    }
</#list>
</#if>

    @Override
    protected void complete(int ${state}) {
<#list completion as way>
        complete(${way.cause}, ${state}, ${way.target});
<@different way "        "/>
<#else>
        // Forbidden: there is no way to go on.
</#list>
    }
}
