package arcomat.generate;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.COMMAND;
import static arcomat.semantics.ComponentBuilder.DISTANCE;
import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.LINE;
import static arcomat.semantics.ComponentBuilder.MOTOR;
import static arcomat.semantics.ComponentBuilder.NOWHERE;
import static arcomat.semantics.ComponentBuilder.SIGNAL;
import static arcomat.semantics.ComponentBuilder.component;
import static arcomat.semantics.ComponentBuilder.constant;
import static arcomat.semantics.ComponentBuilder.range;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.semantics.ComponentBuilder;

import java.util.List;

/** Components that show what generated code has to cope with. */
public final class SampleComponents {
    private SampleComponents() {}

    /** Fig. 6 of the paper. */
    public static Component avoidCrash() {
        return component("AvoidCrash")
                .in(DISTANCE, "frontUS")
                .in(SIGNAL, "timerSig")
                .in(LINE, "ls")
                .totalIn(BOOLEAN, "gotCoffee")
                .out(MOTOR, "cmd")
                .out(COMMAND, "timerCmd")
                .automaton(
                        Completion.IGNORE, "driving", "backing", "waiting", "remote", "returning")
                .initial("driving", "cmd = fwd")
                .on(
                        "driving -> backing",
                        "frontUS = tooClose, gotCoffee = false",
                        "cmd = backRight, timerCmd = delay")
                .on("driving -> waiting", "frontUS = tooClose, gotCoffee = true", "cmd = stop")
                .on("waiting -> driving", "frontUS = clear", "cmd = fwd")
                .on("backing -> remote", "timerSig = alert", "cmd = stop")
                .on("remote -> returning", "frontUS = clear", "cmd = fwd")
                .on("returning -> driving", "ls = ok", "")
                .build();
    }

    /** Fig. 3 of the paper, with its choice between two transitions. */
    public static Component undecided() {
        return component("Undecided")
                .in(DISTANCE, "frontUS")
                .out(MOTOR, "cmd")
                .automaton(Completion.CHAOS, "driving", "sidestep", "waiting")
                .initial("driving", "cmd = fwd")
                .on("driving -> sidestep", "frontUS = tooClose", "cmd = backRight")
                .on("driving -> waiting", "frontUS = tooClose", "cmd = stop")
                .on("waiting -> driving", "frontUS = clear", "cmd = fwd")
                .build();
    }

    /** Counts slices down; forbids what it does not expect, and divides by what may be zero. */
    public static Component timer() {
        ComponentBuilder timer =
                component("Timer")
                        .parameter(range(2, 9), "slices")
                        .in(COMMAND, "timerCmd")
                        .out(SIGNAL, "timerSig")
                        .out(range(0, 6), "share");
        ComponentBuilder.AutomatonBuilder automaton =
                timer.automaton(Completion.ERROR, "idle", "running")
                        .variable(range(0, 9), "left", "0")
                        .initial("idle", "");
        Expression left = automaton.variable("left");
        Expression slices =
                new Expression.ParameterRead(timer.build().parameters().get(0), NOWHERE);
        Expression less = binary(BinaryOperator.MINUS, left, number(1), INTEGER);
        Expression share = binary(BinaryOperator.DIVIDE, number(12), less, INTEGER);
        return automaton
                .on(
                        "idle -> running",
                        "timerCmd = delay",
                        null,
                        List.of(),
                        List.of(automaton.assign("left", slices)))
                .on("idle", "timerCmd = --", "")
                .on(
                        "running",
                        "timerCmd = --",
                        binary(BinaryOperator.GREATER, left, number(1), BOOLEAN),
                        List.of(automaton.send("share", share)),
                        List.of(automaton.assign("left", less)))
                .on(
                        "running -> idle",
                        "timerCmd = --",
                        binary(BinaryOperator.LESS_OR_EQUAL, left, number(1), BOOLEAN),
                        automaton.sends("timerSig = alert"),
                        List.of())
                .build();
    }

    /**
     * A controller, a timer and a sensor with a lamp; a message of the sensor is passed through.
     */
    public static Component whole() {
        Component light =
                component("Light")
                        .platform()
                        .totalOut(INTEGER, "value")
                        .in(range(0, 6), "lamp")
                        .build();
        Component sensors =
                component("Sensors")
                        .part("light", light)
                        .in(range(0, 6), "lamp")
                        .totalOut(INTEGER, "value")
                        .connect("light.value", "value")
                        .connect("lamp", "light.lamp")
                        .build();
        return component("Whole")
                .in(DISTANCE, "front")
                .in(LINE, "ls")
                .totalIn(BOOLEAN, "gotCoffee")
                .out(MOTOR, "cmd")
                .out(INTEGER, "light")
                .part("ctrl", avoidCrash())
                .part("timer", timer(), number(3))
                .part("sensors", sensors)
                .part("undecided", undecided())
                .connect("front", "ctrl.frontUS")
                .connect("front", "undecided.frontUS")
                .connect("ls", "ctrl.ls")
                .connect("gotCoffee", "ctrl.gotCoffee")
                .connect("ctrl.timerCmd", "timer.timerCmd")
                .connect("timer.timerSig", "ctrl.timerSig")
                .connect("timer.share", "sensors.lamp")
                .connect("undecided.cmd", "cmd")
                .connect("sensors.value", "light")
                .build();
    }

    public static Expression number(int value) {
        return constant(INTEGER, String.valueOf(value));
    }

    public static Expression binary(
            BinaryOperator operator, Expression left, Expression right, Type type) {
        return new Expression.Binary(operator, left, right, type, NOWHERE);
    }
}
