<#import "parts.ftl" as parts>
package ${head.packageName};

<@parts.imports head/>
/** Platform component ${head.model} on the brick. */
public final class ${head.name} {
<@parts.ports head/>
    public ${head.name}(<@parts.parameters head/>) {}
<#if senses>

    /** Samples the device and sets the outputs: the start of a slice. Must not wait. */
    public void sense() {}
</#if>
<#if acts>

    /** Carries out what the inputs say: the end of a slice. Must not wait. */
    public void act() {}
</#if>
}
