<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.imports head/>
/**
 * Watches what component ${title} receives and sends, for each of its requirements.
 *
<#if events>
 * <p>Put the {@link #border} into what is watched. Call {@link #slice} after that has started, and
 * after each event, with the message of the event on its port; {@link #violation} says what was
 * not allowed.
<#else>
 * <p>Set the ports to what a slice shows, then call {@link #slice}; {@link #violation} says what
 * was not allowed.
</#if>
 */
public final class ${head.name} {
<#if events>
<@parts.inputs head/>
<#else>
<@parts.ports head/>
</#if>
<#list watchers as watcher>
    /** ${watcher.comment} */
    public final ${watcher.type} ${watcher.name};

</#list>
    public ${head.name}(<@parts.parameters head/>) {
<#list watchers as watcher>
        ${watcher.name} = new ${watcher.type}(<#list head.parameters as parameter>${parameter.name}<#sep>, </#list>);
</#list>
    }

<#if events>
    /** What sees all that the outputs send: put it into the component. */
    public arcomat.rt.Border border() {
        return arcomat.rt.EventMonitor.shared(<#list watchers as watcher>${watcher.name}.border()<#sep>, </#list>);
    }

    /**
     * Judges what was sent since the last call: first what the component has begun with, then what
     * has followed from each event.
     *
     * @return false if a requirement is violated, now or since an earlier event
     */
<#else>
    /**
     * Judges the slice that the ports show.
     *
     * @return false if a requirement is violated, now or since an earlier slice
     */
</#if>
    public boolean slice() {
        copy();
        boolean kept = true;
<#list watchers as watcher>
        kept &= ${watcher.name}.slice();
</#list>
        return kept;
    }

    /**
<#if events>
     * Judges that the program has ended with an error: at the beginning, or after this event.
<#else>
     * Judges that the program has ended with an error in the slice that the ports show: outputs
     * with delay 1 what was sent before, those without delay nothing.
</#if>
     *
     * @return false if a requirement is violated, now or since an earlier <#if events>event<#else>slice</#if>
     */
    public boolean error() {
        copy();
        boolean kept = true;
<#list watchers as watcher>
        kept &= ${watcher.name}.error();
</#list>
        return kept;
    }

    private void copy() {
<#list watchers as watcher>
<@parts.assign watcher.copies/>
</#list>
    }

    /** What was violated, a line for each requirement that was; empty if none was. */
    public String violation() {
        String lines = "";
<#list watchers as watcher>
        lines += line(${watcher.name}.violation());
</#list>
        return lines;
    }

    /** Why it cannot be said whether a requirement is kept, a line for each; empty if it can. */
    public String unknown() {
        String lines = "";
<#list watchers as watcher>
        lines += line(${watcher.name}.unknown());
</#list>
        return lines;
    }

    private static String line(String violation) {
        return violation.length() == 0 ? "" : violation + "\n";
    }
}
