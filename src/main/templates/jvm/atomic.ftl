<#import "parts.ftl" as parts>
<#macro effect transition indent>
<#list transition.locals as local>
${indent}${local.type} ${local.name} = ${local.initial};
</#list>
<#list transition.assignments as assignment>
${indent}${assignment.target} = ${assignment.value};
</#list>
<#if transition.target != "">
${indent}${state} = ${transition.target};
</#if>
${indent}${taken} = ${transition.index};
</#macro>
<#-- Transitions in text order; the first enabled one is taken. -->
<#macro inOrder transitions indent done>
<#list transitions as transition>
<#if transition.comment != "">
${indent}// ${transition.comment}
</#if>
<#if transition.condition == "">
<@effect transition indent/>
${indent}${done}
<#else>
${indent}if (${transition.condition}) {
<@effect transition indent + "    "/>
${indent}    ${done}
${indent}}
</#if>
</#list>
</#macro>
<#-- Transitions that may be enabled together: one of those that are is drawn. -->
<#macro drawn transitions wide indent done>
<#assign one = wide?then("1L", "1")>
${indent}enabled = 0;
<#list transitions as transition>
${indent}if (${transition.condition}) {
${indent}    enabled |= ${one} << ${transition?index};
${indent}}
</#list>
${indent}switch (choice.among(enabled)) {
<#list transitions as transition>
${indent}    case ${transition?index}:
<#if transition.comment != "">
${indent}        // ${transition.comment}
</#if>
<@effect transition indent + "        "/>
${indent}        ${done}
</#list>
${indent}    default:
${indent}        break;
${indent}}
</#macro>
<#macro transitions some indent done>
<#if some.chunks?has_content>
<#list some.chunks as chunk>
${indent}if (${chunk.method}()) {
${indent}    ${done}
${indent}}
</#list>
<#elseif some.chooses>
<@drawn some.transitions some.wide indent done/>
<#else>
<@inOrder some.transitions indent done/>
</#if>
</#macro>
<#macro cases states done>
<#if switches>
        switch (${state}) {
<#list states as some>
            case ${some.label}:<#if !names?has_content> // ${some.name}</#if>
<@transitions some "                " done/>
<#if some.error != "">
                throw new ModelError(${some.error});
<#elseif !some.last>
                break;
</#if>

</#list>
            default:
                break;
        }
<#else>
<#list states as some>
<@transitions some "        " done/>
<#if some.error != "">
        throw new ModelError(${some.error});
</#if>
</#list>
</#if>
</#macro>
<#macro completed indent>
${indent}// No transition is enabled: completion ${completion.kind}, the state is kept.
<#list completion.assignments as assignment>
${indent}${assignment.target} = ${assignment.value};
</#list>
${indent}${taken} = -1;
</#macro>
<#assign names = states>
<@parts.header head/>
<@parts.imports head checks completion.kind == "error"/>
/** Component ${head.model}. */
public final class ${head.name} {
<#list names as name>
    public static final int ${name.constant} = ${name.code};
</#list>
<#if names?has_content>

</#if>
<@parts.ports head/>
<#if head.draws>
    private final Choice choice;
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
<#list variables as variable>
    private ${variable.type} ${variable.name}<#if variable.initial != ""> = ${variable.initial}</#if>;
</#list>
<#if head.draws || head.parameters?has_content || constants?has_content || variables?has_content>

</#if>
    private int ${state};

    /** The transition taken last, by its position in the automaton; -1 for none. */
    private int ${taken} = -1;

    public ${head.name}(<@parts.parameters head/>) {
<#if head.draws>
        this.choice = choice;
</#if>
<#list head.parameters as parameter>
        this.${parameter.name} = ${parameter.name};
</#list>
<#list constructed as assignment>
        ${assignment.target} = ${assignment.value};
</#list>
<#if initials?size == 1>
<@start initials?first "        "/>
<#elseif head.draws>
        switch (choice.next(${initials?size})) {
<#list initials as initial>
            case ${initial?index}:
<@start initial "                "/>
                break;
</#list>
            default:
                break;
        }
<#elseif initials?has_content>
<@start initials?first "        "/>
</#if>
    }

    /**
     * Performs one slice: reads the inputs, then replaces the outputs. What an output with delay
     * carried before this call was visible in the slice; without delay it is so afterwards.
     */
    public void step() {
<#if sectionSize == 0 && sections?first.draws>
        ${wide?then("long", "int")} enabled;
</#if>
<#if sectionSize == 0>
<@cases sections?first.states "return;"/>
<#else>
        switch (${state} / ${sectionSize}) {
<#list sections as section>
            case ${section.number}:
                if (${section.method}()) {
                    return;
                }
                break;
</#list>
            default:
                break;
        }
</#if>
<#if completion.reachable>
<@completed "        "/>
</#if>
    }
<#if sectionSize != 0>
<#list sections as section>

    /** The states from ${section.number * sectionSize} on. */
    private boolean ${section.method}() {
<#if section.draws>
        ${wide?then("long", "int")} enabled;
</#if>
<@cases section.states "return true;"/>
        return false;
    }
</#list>
</#if>
<#list sections as section>
<#list section.states as some>
<#list some.chunks as chunk>

    /** Transitions out of ${some.name}. */
    private boolean ${chunk.method}() {
<@inOrder chunk.transitions "        " "return true;"/>
<#if !chunk.last>
        return false;
</#if>
    }
</#list>
</#list>
</#list>
}
<#macro start initial indent>
<#if initial.comment != "">
${indent}// ${initial.comment}
</#if>
<#list initial.locals as local>
${indent}${local.type} ${local.name} = ${local.initial};
</#list>
<#list initial.assignments as assignment>
${indent}${assignment.target} = ${assignment.value};
</#list>
${indent}${state} = ${initial.target};
</#macro>
