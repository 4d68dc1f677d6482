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
<#list members as member>
<#if member.routes?has_content>
        ${member.part.name} =
                new ${member.part.type}(${member.part.arguments}) {
<#list member.routes as route>
                    protected void ${route.port.method}(${route.port.port.type} message) {
<#list route.calls as call>
                        ${head.name}.this.${call}(message);
</#list>
                    }
<#sep>

</#sep>
</#list>
                };
<#else>
        ${member.part.name} = new ${member.part.type}(${member.part.arguments});
</#if>
</#list>
    }

    /** Starts all parts, in order. */
    public void start() {
<#list members as member>
<#if member.reacts>
        ${member.part.name}.start();
</#if>
</#list>
    }

    /** Lets every part react to one event, in order; false if none waits. */
    public boolean react() {
        boolean reacted = false;
<#list members as member>
<#if member.reacts>
        reacted |= ${member.part.name}.react();
</#if>
</#list>
        return reacted;
    }
<#list inputs as input>

    /** ${input.port.port.comment} */
    public void ${input.port.method}(${input.port.port.type} message) {
<#list input.calls as call>
        ${call}(message);
</#list>
    }
</#list>
<@parts.sending outputs border/>
}
