<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.imports head checks/>
/** Some parts of component ${head.model}, which has too many for one class. */
final class ${name} {
    private final ${head.name} ${whole};
<@parts.members members ""/>

    ${name}(${head.name} ${whole}<#if head.draws || head.parameters?has_content>, </#if><@parts.parameters head/>) {
        this.${whole} = ${whole};
<@parts.construct members fixed loops/>
    }
<#if sensors?has_content>

    void sense() {
<@parts.call sensors "sense"/>
    }
</#if>

    /** Copies what is known when the slice starts. */
    void know() {
<@parts.assign known "receive"/>
<@parts.schedule loops.known/>
<@parts.call knowers "know"/>
    }

    void step() {
<#if loops.reordered>
        // Receivers before senders: what is delayed still shows what was sent in the slice before.
</#if>
<@parts.schedule steps "feed"/>
    }
<@parts.portions known "receive"/>
<@parts.portionsOfSteps steps "feed"/>
<@parts.portions fixed "fix"/>
}
