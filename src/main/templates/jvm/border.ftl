<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.imports head false false true/>
/**
 * Platform component ${head.model}, driven by events. On this target it is the border of the
 * program: whoever drives it sends on its outputs and sees what reaches its inputs.
 */
public class ${head.name} {
<@parts.border border/>

    public ${head.name}(<@parts.parameters head/>) {}
<#list inputs as input>

    /** ${input.port.port.comment} */
    public void ${input.port.method}(${input.port.port.type} message) {
        if (${border} != null) {
            ${border}.sent(${input.port.literal}, message);
        }
    }
</#list>
<@parts.sending outputs border/>
}
