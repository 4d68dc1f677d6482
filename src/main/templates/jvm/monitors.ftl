<#import "parts.ftl" as parts>
<@parts.header head/>
<@parts.imports head/>
/**
 * Watches what component ${title} receives and sends, for each of its requirements.
 *
 * <p>Set the ports to what a slice shows, then call {@link #slice}; {@link #violation} says what
 * was not allowed.
 */
public final class ${head.name} {
<@parts.ports head/>
<#list watchers as watcher>
    /** ${watcher.comment} */
    public final ${watcher.type} ${watcher.name};

</#list>
    public ${head.name}(<@parts.parameters head/>) {
<#list watchers as watcher>
        ${watcher.name} = new ${watcher.type}(<#list head.parameters as parameter>${parameter.name}<#sep>, </#list>);
</#list>
    }

    /**
     * Judges the slice that the ports show.
     *
     * @return false if a requirement is violated, now or since an earlier slice
     */
    public boolean slice() {
<#list watchers as watcher>
<@parts.assign watcher.copies/>
</#list>
        boolean kept = true;
<#list watchers as watcher>
        kept &= ${watcher.name}.slice();
</#list>
        return kept;
    }

    /** What was violated, a line for each requirement that was; empty if none was. */
    public String violation() {
        String lines = "";
<#list watchers as watcher>
        lines += line(${watcher.name}.violation());
</#list>
        return lines;
    }

    private static String line(String violation) {
        return violation.length() == 0 ? "" : violation + "\n";
    }
}
