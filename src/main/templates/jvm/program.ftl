<#import "parts.ftl" as parts>
<@parts.header head/>
<#if head.draws>
import arcomat.rt.Choice;
</#if>
import arcomat.rt.Cycle;

/** Runs component ${head.model}: one slice per cycle, for ever. */
public final class ${name} {
    private ${name}() {}

    public static void main(String[] args) {
        ${head.name} whole = new ${head.name}(<#if head.draws>new Choice((int) System.currentTimeMillis())</#if>);
        Cycle cycle = new Cycle(${cycle});
<#if events>
        whole.start();
</#if>
        while (cycle.await()) {
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
}
