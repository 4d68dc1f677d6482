<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.classes head/>
/**
 * Platform component ${head.model}. On this target its ports are the border of the program: whoever
 * drives it sets the outputs before a slice and reads the inputs after it.
 */
public final class ${head.name} {
<@parts.ports head/>
    public ${head.name}(<@parts.parameters head/>) {}
<#if senses>

    /** Samples the outputs: the start of a slice. */
    public void sense() {}
</#if>
<#if acts>

    /** Carries out the inputs of a slice. */
    public void act() {}
</#if>
}
