<#-- The behaviour of an automaton, whatever its profile; a is its view. -->
<#-- One state need not be remembered, unless somebody looks. -->
<#function remembers a><#return a.switches || a.traced></#function>
<#macro effect a transition indent>
<#list transition.locals as local>
${indent}${local.type} ${local.name} = ${local.initial};
</#list>
<#list transition.messages as message>
${indent}${message.target}(${message.value});
</#list>
<#list transition.assignments as assignment>
${indent}${assignment.target} = ${assignment.value};
</#list>
<@statements transition indent/>
<#if transition.target != "">
${indent}${a.state} = ${transition.target};
</#if>
<#if a.traced>
${indent}${a.taken} = ${(transition.statements.way == "")?then(transition.index, transition.statements.way)};
</#if>
</#macro>
<#macro statements transition indent>
<#if transition.statements.way != "">
${indent}int ${transition.statements.way} = ${transition.index};
</#if>
<#list transition.statements.lines as line>
<#local here = indent + ""?left_pad(4 * line.depth)>
<#switch line.kind>
<#case "declare">
${here}${line.type} ${line.target} = ${line.value};
<#break>
<#case "assign">
${here}${line.target} = ${line.value};
<#break>
<#case "call">
${here}${line.target}(${line.value});
<#break>
<#case "count">
${here}${line.target} += ${line.value};
<#break>
<#case "if">
${here}if (${line.value}) {
<#break>
<#case "elseif">
${here}} else if (${line.value}) {
<#break>
<#case "else">
${here}} else {
<#break>
<#case "end">
${here}}
<#break>
<#case "stop">
${here}break ${transition.statements.label};
<#break>
</#switch>
</#list>
</#macro>
<#-- Whether something is declared, or a place behind it has a name. -->
<#function isClosed transition>
<#local some = transition.statements>
<#return transition.locals?has_content || some.label != "" || some.way != ""
    || some.lines?filter(line -> line.kind == "declare" && line.depth == 0)?has_content>
</#function>
<#function labelled transition>
<#return (transition.statements.label == "")?then("", transition.statements.label + ": ")>
</#function>
<#-- Transitions in text order; the first enabled one is taken. -->
<#macro inOrder a transitions indent done>
<#list transitions as transition>
<#if transition.comment != "">
${indent}// ${transition.comment}
</#if>
<#if transition.condition == "" && isClosed(transition)>
${indent}${labelled(transition)}{
<@effect a transition indent + "    "/>
${indent}    ${done}${transition.mark}
${indent}}
<#elseif transition.condition == "">
<@effect a transition indent/>
${indent}${done}${transition.mark}
<#else>
${indent}<#if transition.statements.label != "">${labelled(transition)}</#if>if (${transition.condition}) {
<@effect a transition indent + "    "/>
${indent}    ${done}${transition.mark}
${indent}}
</#if>
</#list>
</#macro>
<#-- Transitions that may be enabled together: one of those that are is drawn. -->
<#macro drawn a transitions wide indent done>
<#local one = wide?then("1L", "1")>
${indent}enabled = 0;
<#list transitions as transition>
${indent}if (${transition.condition}) {
${indent}    enabled |= ${one} << ${transition?index};
${indent}}
</#list>
${indent}switch (choice.among(enabled)) {
<#list transitions as transition>
${indent}    case ${transition?index}:<#if transition.locals?has_content> {</#if>
<#if transition.comment != "">
${indent}        // ${transition.comment}
</#if>
<@effect a transition indent + "        "/>
${indent}        ${done}${transition.mark}
<#if transition.locals?has_content>
${indent}    }
</#if>
</#list>
${indent}    default:
${indent}        break;
${indent}}
</#macro>
<#macro transitions a some indent done>
<#if some.chunks?has_content>
<#list some.chunks as chunk>
${indent}if (${chunk.method}()) {
${indent}    ${done}
${indent}}
</#list>
<#elseif some.chooses>
<@drawn a some.transitions some.wide indent done/>
<#else>
<@inOrder a some.transitions indent done/>
</#if>
</#macro>
<#macro cases a states done>
<#if a.switches>
        switch (${a.state}) {
<#list states as some>
            case ${some.label}:<#if !a.states?has_content> // ${some.name}</#if>
<@transitions a some "                " done/>
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
<@transitions a some "        " done/>
<#if some.error != "">
        throw new ModelError(${some.error});
</#if>
</#list>
</#if>
</#macro>
<#macro completed a indent>
${indent}// No transition is enabled: completion ${a.completion.kind}, the state is kept.
<#list a.completion.assignments as assignment>
${indent}${assignment.target} = ${assignment.value};
</#list>
<#if a.traced>
${indent}${a.taken} = -1;
</#if>
</#macro>
<#macro start a initial indent>
<#if initial.comment != "">
${indent}// ${initial.comment}
</#if>
<#list initial.locals as local>
${indent}${local.type} ${local.name} = ${local.initial};
</#list>
<#list initial.messages as message>
${indent}${message.target}(${message.value});
</#list>
<#list initial.assignments as assignment>
${indent}${assignment.target} = ${assignment.value};
</#list>
<#if remembers(a)>
${indent}${a.state} = ${initial.target};
</#if>
</#macro>
<#-- Where nothing is drawn, it has begun at the end of what calls this. -->
<#function begun a>
<#return (a.initials?size == 1 || a.initials?has_content && !a.head.draws)?then(a.initials?first.mark, "")>
</#function>
<#macro states a>
<#if remembers(a) && a.states?has_content>
<#list a.states as name>
    public static final int ${name.constant} = ${name.code};
</#list>

</#if>
</#macro>
<#macro fields a>
<#if a.head.draws>
    private final Choice choice;
</#if>
<#list a.head.parameters as parameter>
    private final ${parameter.type} ${parameter.name};
</#list>
<#list a.constants as constant>
<#if constant.initial != "">
    private static final ${constant.type} ${constant.name} = ${constant.initial};
<#else>
    private final ${constant.type} ${constant.name};
</#if>
</#list>
<#list a.variables as variable>
    private ${variable.type} ${variable.name}<#if variable.initial != ""> = ${variable.initial}</#if>;
</#list>
<#if a.head.draws || a.head.parameters?has_content || a.constants?has_content || a.variables?has_content>

</#if>
<#if remembers(a)>
    private int ${a.state};

</#if>
<#if a.traced>
    /** The transition taken last, by its position in the automaton; -1 for none. */
    private int ${a.taken} = -1;

</#if>
</#macro>
<#macro construct a>
<#if a.head.draws>
        this.choice = choice;
</#if>
<#list a.head.parameters as parameter>
        this.${parameter.name} = ${parameter.name};
</#list>
<#list a.constructed as assignment>
        ${assignment.target} = ${assignment.value};
</#list>
</#macro>
<#macro begin a>
<#if a.initials?size == 1>
<@start a a.initials?first "        "/>
<#elseif a.head.draws>
        switch (choice.next(${a.initials?size})) {
<#list a.initials as initial>
            case ${initial?index}:<#if initial.locals?has_content> {</#if>
<@start a initial "                "/>
                break;${initial.mark}
<#if initial.locals?has_content>
            }
</#if>
</#list>
            default:
                break;
        }
<#elseif a.initials?has_content>
<@start a a.initials?first "        "/>
</#if>
</#macro>
<#macro step a>
<#if a.silences?has_content>
        // Silent, unless something is sent below.
<#list a.silences as assignment>
        ${assignment.target} = ${assignment.value};
</#list>

</#if>
<#if a.sectionSize == 0 && a.sections?first.draws>
        ${a.wide?then("long", "int")} enabled;
</#if>
<#if a.sectionSize == 0>
<@cases a a.sections?first.states "return;"/>
<#else>
        switch (${a.state} / ${a.sectionSize}) {
<#list a.sections as section>
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
<#if a.completion.reachable>
<@completed a "        "/>
</#if>
</#macro>
<#macro methods a>
<#if a.sectionSize != 0>
<#list a.sections as section>

    /** The states from ${section.number * a.sectionSize} on. */
    private boolean ${section.method}() {
<#if section.draws>
        ${a.wide?then("long", "int")} enabled;
</#if>
<@cases a section.states "return true;"/>
        return false;
    }
</#list>
</#if>
<#list a.sections as section>
<#list section.states as some>
<#list some.chunks as chunk>

    /** Transitions out of ${some.name}. */
    private boolean ${chunk.method}() {
<@inOrder a chunk.transitions "        " "return true;"/>
<#if !chunk.last>
        return false;
</#if>
    }
</#list>
</#list>
</#list>
<#list a.conditions as some>

<#if !some.judged>
    /** Whether that part of a long condition holds. */
    private boolean ${some.method}() {
        return ${some.condition};
    }
<#elseif some.wrong == "">
    /** What is known of that part of a condition. */
    private int ${some.method}() {
        return ${some.condition};
    }
<#else>
    /** What is known of that part of a condition, which may go wrong. */
    private int ${some.method}() {
        try {
            return ${some.condition};
        } catch (arcomat.rt.ModelError wrong) {
            return ${some.wrong};
        }
    }
</#if>
</#list>
</#macro>
