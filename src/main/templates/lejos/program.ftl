<#import "parts.ftl" as parts>
<@parts.header head/>
<#if head.draws>
import arcomat.rt.Choice;

</#if>
/** Runs component ${head.model} on the brick: one slice per cycle, until ESCAPE is pressed. */
public final class ${name} extends arcomat.nxt.<#if watches?has_content>WatchedRobot<#else>Robot</#if> {
    private ${head.name} whole;
<#list watches as watch>

    /** ${watch.comment} */
    private ${watch.type} ${watch.name};
</#list>

    private ${name}() {}

    public static void main(String[] args) {
        new ${name}().run(${cycle});
    }

    protected void start() {
        whole = new ${head.name}(<#if head.draws>new Choice((int) System.currentTimeMillis())</#if>);
<#if events>
        whole.start();
</#if>
<#list watches as watch>
        ${watch.name} = new ${watch.type}(${watch.arguments});
        begin(${watch.name});
<#list watch.fixed as flag>
        ${watch.name}.${flag} = true;
</#list>
</#list>
    }

    protected void slice() {
<#if events>
        while (whole.react()) {
            // Until no event waits.
        }
<#else>
<#if senses>
        whole.sense();
</#if>
<#list watches as watch>
<#list watch.before as copy>
        ${watch.name}.${copy.target} = whole.${copy.value};
</#list>
</#list>
<#if call != "">
        whole.${call}();
</#if>
<#list watches as watch>
<#list watch.after as copy>
        ${watch.name}.${copy.target} = whole.${copy.value};
</#list>
</#list>
<#list watches as watch>
        ${watch.goesOn?then("goOn", "demand")}(${watch.name});
</#list>
</#if>
    }
}
