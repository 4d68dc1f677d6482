<#import "parts.ftl" as parts>
<@parts.header head/>
<#if head.draws>
import arcomat.rt.Choice;

</#if>
/** Runs component ${head.model} on the brick: one slice per cycle, until ESCAPE is pressed. */
public final class ${name} extends arcomat.nxt.Robot {
    private ${head.name} whole;

    private ${name}() {}

    public static void main(String[] args) {
        new ${name}().run(${cycle});
    }

    protected void start() {
        whole = new ${head.name}(<#if head.draws>new Choice((int) System.currentTimeMillis())</#if>);
<#if events>
        whole.start();
</#if>
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
<#if call != "">
        whole.${call}();
</#if>
</#if>
    }
}
