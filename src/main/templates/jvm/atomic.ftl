<#import "parts.ftl" as parts>
<#import "automaton.ftl" as automaton>
<#assign self = .data_model>
<@parts.header head/>
<#assign errors = sections?filter(one -> one.states?filter(some -> some.error != "")?has_content)>
<@parts.imports head checks errors?has_content/>
/** Component ${head.model}. */
public final class ${head.name} {
<@automaton.states self/>
<@parts.ports head/>
<@automaton.fields self/>
    public ${head.name}(<@parts.parameters head/>) {
<@automaton.construct self/>
<@automaton.begin self/>
    }${automaton.begun(self)}

    /**
     * Performs one slice: reads the inputs, then replaces the outputs. What an output with delay
     * carried before this call was visible in the slice; without delay it is so afterwards.
     */
    public void step() {
<@automaton.step self/>
    }
<@automaton.methods self/>
}
