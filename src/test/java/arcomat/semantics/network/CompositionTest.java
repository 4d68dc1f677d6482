package arcomat.semantics.network;

import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.NOWHERE;
import static arcomat.semantics.ComponentBuilder.component;
import static arcomat.semantics.ComponentBuilder.constant;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.expression.Fault;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.List;

class CompositionTest {
    private static final Component INSTANT = pass("Instant", true);
    private static final Component DELAYED = pass("Delayed", false);

    private static Component pass(String name, boolean instant) {
        ComponentBuilder builder = component(name).in(INTEGER, "i");
        return (instant ? builder.instantOut(INTEGER, "o") : builder.out(INTEGER, "o"))
                .automaton(Completion.IGNORE, "only")
                .initial("only", "")
                .build();
    }

    private static ComponentBuilder whole(String name) {
        return component(name).in(INTEGER, "i").out(INTEGER, "o");
    }

    private static List<String> order(Component component) {
        return Composition.of(component).nodes().stream().map(Composition.Node::path).toList();
    }

    @Test
    void readersOfFreshMessagesComeAfterTheirSenders() {
        Component chain =
                whole("Chain")
                        .part("last", INSTANT)
                        .part("middle", INSTANT)
                        .part("first", INSTANT)
                        .connect("i", "first.i")
                        .connect("first.o", "middle.i")
                        .connect("middle.o", "last.i")
                        .connect("last.o", "o")
                        .build();
        assertThat(order(chain)).containsExactly("first", "middle", "last");
    }

    @Test
    void tiesAndDelayedMessagesKeepTheOrderOfDeclaration() {
        Component chain =
                whole("Chain")
                        .part("b", DELAYED)
                        .part("a", DELAYED)
                        .part("free", INSTANT)
                        .connect("a.o", "b.i")
                        .connect("b.o", "a.i")
                        .build();
        assertThat(order(chain)).containsExactly("b", "a", "free");
    }

    /** Two lanes in one component: contracted, lane one waits for lane two and the reverse. */
    private static Component lanes() {
        return component("Lanes")
                .parameter(INTEGER, "n")
                .in(INTEGER, "i1")
                .in(INTEGER, "i2")
                .instantOut(INTEGER, "o1")
                .instantOut(INTEGER, "o2")
                .part("one", INSTANT)
                .part("two", INSTANT)
                .connect("i1", "one.i")
                .connect("i2", "two.i")
                .connect("one.o", "o1")
                .connect("two.o", "o2")
                .build();
    }

    @Test
    void aCompositeThatClosesACycleOnlyByContractionIsDissolved() {
        Component whole =
                whole("Whole")
                        .part("lanes", lanes(), constant(INTEGER, "1"))
                        .part("between", INSTANT)
                        .connect("i", "lanes.i2")
                        .connect("lanes.o2", "between.i")
                        .connect("between.o", "lanes.i1")
                        .connect("lanes.o1", "o")
                        .build();
        assertThat(order(whole)).containsExactly("lanes.two", "between", "lanes.one");
        Composition composition = Composition.of(whole);
        assertThat(composition.outputs().get(0).source())
                .isInstanceOfSatisfying(
                        Source.FromNode.class, source -> assertThat(source.node()).isEqualTo(2));
    }

    @Test
    void aCompositeThatFeedsItselfThroughDifferentLanesIsDissolved() {
        Component whole =
                whole("Whole")
                        .part("lanes", lanes(), constant(INTEGER, "1"))
                        .connect("i", "lanes.i2")
                        .connect("lanes.o2", "lanes.i1")
                        .connect("lanes.o1", "o")
                        .build();
        assertThat(order(whole)).containsExactly("lanes.two", "lanes.one");
    }

    @Test
    void argumentsThatGoWrongAreNamedWithTheirPart() {
        Expression quotient =
                new Expression.Binary(
                        Expression.BinaryOperator.DIVIDE,
                        constant(INTEGER, "1"),
                        constant(INTEGER, "0"),
                        INTEGER,
                        NOWHERE);
        Component part = component("Part").parameter(INTEGER, "n").build();
        Component whole = component("Whole").part("divide", part, quotient).build();
        assertThatThrownBy(() -> Network.of(whole, List.of()))
                .isInstanceOfSatisfying(
                        Fault.class,
                        fault -> {
                            assertThat(fault.problem()).isEqualTo("division by zero");
                            assertThat(fault.kind()).isEqualTo(Fault.Kind.DIVISION_BY_ZERO);
                        })
                .hasMessage("Whole, arguments of divide: division by zero");
    }

    /** Paths are followed in the order of the schedule, not by a call per part. */
    @Test
    void aVeryLongChainIsNoDeepRecursion() {
        ComponentBuilder chain =
                component("Chain").in(INTEGER, "i").instantOut(INTEGER, "o").connect("i", "p0.i");
        int length = 20_000;
        for (int k = 0; k < length; k++) {
            chain.part("p" + k, INSTANT);
            chain.connect("p" + k + ".o", k + 1 < length ? "p" + (k + 1) + ".i" : "o");
        }
        assertThat(Feedthrough.of(chain.build(), true).get("o").get(0)).isTrue();
    }

    @Test
    void nestedCompositesDissolveAsFarAsNeeded() {
        Component outer =
                component("Outer")
                        .in(INTEGER, "i1")
                        .in(INTEGER, "i2")
                        .instantOut(INTEGER, "o1")
                        .instantOut(INTEGER, "o2")
                        .part("lanes", lanes(), constant(INTEGER, "1"))
                        .connect("i1", "lanes.i1")
                        .connect("i2", "lanes.i2")
                        .connect("lanes.o1", "o1")
                        .connect("lanes.o2", "o2")
                        .build();
        Component whole =
                whole("Whole")
                        .part("outer", outer)
                        .connect("i", "outer.i2")
                        .connect("outer.o2", "outer.i1")
                        .connect("outer.o1", "o")
                        .build();
        assertThat(order(whole)).containsExactly("outer.lanes.two", "outer.lanes.one");
    }

    @Test
    void aCompositeOutsideOfCyclesStaysWhole() {
        Component whole =
                whole("Whole")
                        .part("after", INSTANT)
                        .part("lanes", lanes(), constant(INTEGER, "1"))
                        .connect("i", "lanes.i1")
                        .connect("lanes.o1", "after.i")
                        .build();
        assertThat(order(whole)).containsExactly("lanes", "after");
    }

    @Test
    void aTrueCycleIsNamed() {
        Component whole =
                whole("Whole")
                        .part("ctrl", INSTANT)
                        .part("timer", INSTANT)
                        .part("reader", INSTANT)
                        .connect("ctrl.o", "timer.i")
                        .connect("timer.o", "ctrl.i")
                        .connect("timer.o", "reader.i")
                        .build();
        assertThatThrownBy(() -> Composition.of(whole))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageEndingWith("circle between ctrl, timer");
    }

    @Test
    void messagesThatACompositeOnlyPassesOnAreFollowed() {
        Component pipe =
                component("Pipe")
                        .in(INTEGER, "i")
                        .instantOut(INTEGER, "o")
                        .part("bystander", INSTANT)
                        .connect("i", "o")
                        .build();
        Component whole =
                whole("Whole")
                        .part("pipe", pipe)
                        .part("second", pipe)
                        .connect("i", "pipe.i")
                        .connect("pipe.o", "second.i")
                        .connect("second.o", "o")
                        .build();
        assertThat(Composition.of(whole).outputs().get(0).source())
                .isInstanceOf(Source.FromOutside.class);
    }

    @Test
    void argumentsReachTheInstances() {
        Component leaf =
                component("Leaf")
                        .parameter(INTEGER, "k")
                        .in(INTEGER, "i")
                        .out(INTEGER, "o")
                        .automaton(Completion.IGNORE, "only")
                        .initial("only", "")
                        .build();
        ComponentBuilder middle = component("Middle").parameter(INTEGER, "n");
        Expression n =
                new Expression.ParameterRead(
                        middle.build().parameters().get(0), ComponentBuilder.NOWHERE);
        Expression twice =
                new Expression.Binary(
                        Expression.BinaryOperator.PLUS, n, n, INTEGER, ComponentBuilder.NOWHERE);
        Component whole =
                whole("Whole")
                        .part(
                                "middle",
                                middle.part("leaf", leaf, twice).build(),
                                constant(INTEGER, "21"))
                        .build();
        Network.Instance instance = Network.of(whole, List.of()).instances().get(0);
        assertThat(instance.path()).isEqualTo("middle.leaf");
        assertThat(instance.arguments()).containsExactly(new Value.IntegerValue(42));
    }

    @Test
    void portsOfPlatformComponentsAreExternal() {
        Component sensor = component("Light").platform().instantOut(INTEGER, "value").build();
        Component motor = component("Motor").platform().in(INTEGER, "power").build();
        Component whole =
                whole("Whole")
                        .part("motor", motor)
                        .part("control", DELAYED)
                        .part("left", sensor)
                        .connect("left.value", "control.i")
                        .connect("control.o", "motor.power")
                        .build();
        Network network = Network.of(whole, List.of());
        assertThat(network.inputs().stream().map(Network.External::name))
                .containsExactly("i", "left.value");
        assertThat(network.outputs().stream().map(Network.External::name))
                .containsExactly("o", "motor.power");
        Network.Instance control = network.instances().get(0);
        assertThat(control.inputSignals()).containsExactly(network.inputs().get(1).signal());
        assertThat(control.outputSignals()).containsExactly(network.outputs().get(1).signal());
        assertThat(network.outputs().get(0).signal()).isEqualTo(Network.UNCONNECTED);
    }

    @Test
    void fiftyThousandPartsAreElaboratedQuickly() {
        ComponentBuilder chain = whole("Chain");
        int size = 50_000;
        for (int k = size - 1; k >= 0; k--) {
            chain.part("p" + k, INSTANT);
            chain.connect(k == 0 ? "i" : "p" + (k - 1) + ".o", "p" + k + ".i");
        }
        Component component = chain.connect("p" + (size - 1) + ".o", "o").build();
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long start = threads.getCurrentThreadCpuTime();
        Network network = Network.of(component, List.of());
        Duration took = Duration.ofNanos(threads.getCurrentThreadCpuTime() - start);
        assertThat(network.instances()).hasSize(size);
        assertThat(network.instances().get(0).path()).isEqualTo("p0");
        assertThat(took).isLessThan(Duration.ofSeconds(5));
    }
}
