<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.imports head checks false true/>
/** Component ${head.model}, driven by events. */
public class ${head.name} {
<@parts.border border/>

<#list members as member>
    public final ${member.part.type} ${member.part.name};
</#list>

    public ${head.name}(<@parts.parameters head/>) {
<@parts.connect members head.name/>
    }

<@parts.live members/>
<#list inputs as input>

    /** ${input.port.port.comment} */
    public void ${input.port.method}(${input.port.port.type} message) {
<#list input.calls as call>
        ${call}(message);
</#list>
    }
</#list>
<@parts.shares shares/>
<@parts.sending outputs border/>
}
