package arcomat.simulate.run;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.component;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.semantics.ComponentBuilder;
import arcomat.simulate.Runs;

import org.junit.jupiter.api.Test;

import java.util.List;

class EventsTest {
    private static List<String> run(Component component, String... letters) {
        return Runs.lines(Runs.run(component, Choice.first(), letters));
    }

    /** Sends a finite stream per event. */
    private static Component repeater(String name, String messages) {
        return component(name)
                .eventDriven()
                .queueCapacity(3)
                .in(INTEGER, "i")
                .out(INTEGER, "o")
                .automaton(Completion.IGNORE, "only")
                .initial("only", "")
                .on("only", "i = ?", messages)
                .build();
    }

    private static Component chain(Component first, Component second) {
        return component("Chain")
                .eventDriven()
                .in(INTEGER, "i")
                .out(INTEGER, "o")
                .part("second", second)
                .part("first", first)
                .connect("i", "first.i")
                .connect("first.o", "second.i")
                .connect("second.o", "o")
                .build();
    }

    @Test
    void anEventRunsToCompletionThroughTheNetwork() {
        assertThat(run(chain(repeater("A", "o = 1|2"), repeater("B", "o = 7|8")), "i=0"))
                .containsExactly(
                        "o=7,8,7,8 | first: only t0 only | second: only t0 only"
                                + " | second: only t0 only");
    }

    @Test
    void aFullQueueEndsTheRun() {
        assertThat(run(chain(repeater("A", "o = 1|2|3|4"), repeater("B", "")), "i=0"))
                .containsExactly(
                        "! step 0: second: the queue is full: 3 events wait, another on i does not"
                                + " fit");
    }

    @Test
    void messagesThatCircleForEverEndTheRun() {
        Component ring =
                component("Ring")
                        .eventDriven()
                        .in(INTEGER, "i")
                        .part("first", repeater("A", "o = 1"))
                        .part("second", repeater("B", "o = 1"))
                        .part("start", repeater("C", "o = 1"))
                        .connect("i", "start.i")
                        .connect("first.o", "second.i")
                        .connect("second.o", "first.i")
                        .build();
        assertThat(run(ring, "i=0")).hasSize(1);
        Component fed =
                component("Fed")
                        .eventDriven()
                        .part("first", seeded())
                        .part("second", repeater("B", "o = 1"))
                        .connect("first.o", "second.i")
                        .connect("second.o", "first.i")
                        .build();
        assertThat(Runs.run(fed, Choice.first(), "").failure())
                .hasValueSatisfying(f -> assertThat(f).contains("messages circle without end"));
    }

    private static Component seeded() {
        return component("Seeded")
                .eventDriven()
                .in(INTEGER, "i")
                .out(INTEGER, "o")
                .automaton(Completion.IGNORE, "only")
                .initial("only", "o = 1")
                .on("only", "i = ?", "o = 1")
                .build();
    }

    @Test
    void initialOutputsComeBeforeTheFirstEvent() {
        Component greeting =
                component("Greeting")
                        .eventDriven()
                        .in(INTEGER, "i")
                        .out(INTEGER, "o")
                        .automaton(Completion.IGNORE, "only")
                        .initial("only", "o = 1")
                        .on("only", "i = ?", "o = 2")
                        .build();
        assertThat(run(greeting, "i=0", "i=0"))
                .containsExactly("o=1,2 | only t0 only", "o=2 | only t0 only");
        assertThat(run(greeting, "")).containsExactly("o=1");
    }

    @Test
    void aLatchedPortIsReadButTriggersNothing() {
        ComponentBuilder builder =
                component("Gate")
                        .eventDriven()
                        .in(INTEGER, "i")
                        .latchedIn(BOOLEAN, "open")
                        .out(INTEGER, "o");
        Expression open = builder.read("open");
        ComponentBuilder.AutomatonBuilder automaton =
                builder.automaton(Completion.IGNORE, "only").initial("only", "");
        Component gate =
                automaton.on("only", "i = ?", open, automaton.sends("o = 1"), List.of()).build();
        assertThat(run(gate, "i=0", "open=true", "i=0", "i=0", "open=false", "i=0"))
                .containsExactly(
                        " | only IGNORE only",
                        "",
                        "o=1 | only t0 only",
                        "o=1 | only t0 only",
                        "",
                        " | only IGNORE only");
    }
}
