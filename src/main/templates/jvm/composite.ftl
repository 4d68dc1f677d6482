<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.imports head checks/>
/** Component ${head.model}. */
public final class ${head.name} {
<@parts.ports head/>
<@parts.members members "public "/>

    public ${head.name}(<@parts.parameters head/>) {
<@parts.construct members fixed loops/>
<@parts.assign registers "sendDelayed"/>
    }
<#if sensors?has_content>

    /** Samples the sensors: the start of a slice. */
    public void sense() {
<@parts.call sensors "sense"/>
<@parts.assign sensed "show"/>
    }
</#if>

    /** Performs one slice. */
    public void step() {
<#if known?has_content || loops.known?has_content || knowers?has_content>
        // Known when the slice starts: from outside, from sensors, and sent in the slice before.
<@parts.assign known "receive"/>
<@parts.schedule loops.known/>
<@parts.call knowers "know"/>

</#if>
<#if loops.reordered>
        // Receivers before senders: what is delayed still shows what was sent in the slice before.
</#if>
<@parts.schedule steps "feed"/>
<#if registers?has_content || fresh?has_content>

</#if>
<@parts.assign fresh "send"/>
<@parts.assign registers "sendDelayed"/>
    }
<@parts.portions sensed "show"/>
<@parts.portions known "receive"/>
<@parts.portionsOfSteps steps "feed"/>
<@parts.portions fresh "send"/>
<@parts.portions registers "sendDelayed"/>
<@parts.portions fixed "fix"/>
}
