<#import "parts.ftl" as parts>
<#import "automaton.ftl" as machine>
<@parts.header head/>
<@parts.imports head automaton.checks true true/>
/** Component ${head.model}, driven by events. */
public class ${head.name} {
<@machine.states automaton/>
<@parts.border border/>

<#list inputs as input>
    /** ${input.port.comment} */
    private ${input.port.type} ${input.port.name}<#if input.first != ""> = ${input.first}</#if>;
<#if input.port.flag != "">
    private boolean ${input.port.flag};
</#if>

</#list>
<@machine.fields automaton/>
    /** Ports of the events that wait, a ring, and port by port their messages. */
    private final int[] ${waiting} = new int[${capacity}];
<#list inputs as input>
<#if input.buffer != "">
    private final ${input.port.type}[] ${input.buffer} = new ${input.port.type}[${capacity}];
</#if>
</#list>
    private int ${oldest};
    private int ${count};

    public ${head.name}(<@parts.parameters head/>) {
<@machine.construct automaton/>
    }

    /** Takes an initial state and sends the initial output. */
    public void start() {
<@machine.begin automaton/>
    }${machine.begun(automaton)}
<#list inputs as input>

    /** ${input.port.comment} */
    public void ${input.method}(${input.port.type} message) {
<#if input.latched>
        ${input.port.name} = message;
<#if input.port.flag != "">
        ${input.port.flag} = true;
</#if>
<#else>
        ${input.buffer}[place(${input.number}, ${input.literal})] = message;
</#if>
    }
</#list>

    /** The place of a new event in the ring. */
    private int place(int port, String name) {
        int place = (${oldest} + ${count}) % ${capacity};
        if (${count}++ == ${capacity}) {
            throw new ModelError(
                    "the queue is full: ${capacity} events wait, another on " + name + " does not fit");
        }
        ${waiting}[place] = port;
        return place;
    }

    /** Reacts to the event that has waited longest; false if none waits. */
    public boolean react() {
        if (${count} == 0) {
            return false;
        }
        int place = ${oldest};
        ${oldest} = (place + 1) % ${capacity};
        ${count}--;
        switch (${waiting}[place]) {
<#list inputs as input>
<#if input.buffer != "">
            case ${input.number}:
                ${input.port.name} = ${input.buffer}[place];
<#if input.port.flag != "">
                ${input.port.flag} = true;
                handle();
                ${input.port.flag} = false;
<#else>
                handle();
                ${input.port.name} = 0;
</#if>
                break;
</#if>
</#list>
            default:
                break;
        }
        return true;
    }

    /** Handles the one event that is present. */
    private void handle() {
<@machine.step automaton/>
    }
<@machine.methods automaton/>
<@parts.sending outputs border/>
}
