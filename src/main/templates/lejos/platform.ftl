<#import "parts.ftl" as parts>
<#if general != "">
<@parts.header head/>
/** Platform component ${head.model} on the brick. */
public final class ${head.name} extends ${general} {
    public ${head.name}(<@parts.parameters head/>) {
        super(<#list head.parameters as parameter>${parameter.name}<#sep>, </#list>);
    }
}
<#else>
package ${head.packageName};

<@parts.classes head/>
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
</#if>
