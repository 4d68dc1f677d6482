<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.imports head checks/>
/** Some parts of component ${head.model}, which has too many for one class. */
public final class ${name} {
    final ${head.name} ${whole};
<#list members as member>
    public final ${member.part.type} ${member.part.name};
</#list>

    ${name}(${head.name} ${whole}<#if head.draws || head.parameters?has_content>, </#if><@parts.parameters head/>) {
        this.${whole} = ${whole};
<@parts.connect members name/>
    }

<@parts.live members/>
<@parts.shares shares/>
}
