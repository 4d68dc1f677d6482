package arcomat.semantics;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.COMMAND;
import static arcomat.semantics.ComponentBuilder.DISTANCE;
import static arcomat.semantics.ComponentBuilder.LINE;
import static arcomat.semantics.ComponentBuilder.MOTOR;
import static arcomat.semantics.ComponentBuilder.SIGNAL;
import static arcomat.semantics.ComponentBuilder.component;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;

/** The three versions of AvoidCrash in the paper, each with a completion of one's choice. */
public final class CoffeeFigures {
    private CoffeeFigures() {}

    public static Component figure3(Completion completion) {
        return component("AvoidCrash3")
                .in(DISTANCE, "frontUS")
                .out(MOTOR, "cmd")
                .automaton(completion, "driving", "sidestep", "waiting")
                .initial("driving", "cmd = fwd")
                .on("driving -> sidestep", "frontUS = tooClose", "cmd = backRight")
                .on("driving -> waiting", "frontUS = tooClose", "cmd = stop")
                .on("waiting -> driving", "frontUS = clear", "cmd = fwd")
                .build();
    }

    public static Component figure5(Completion completion) {
        return figure5Ports("AvoidCrash5")
                .automaton(completion, "driving", "backing", "waiting", "remote", "returning")
                .initial("driving", "cmd = fwd")
                .on("driving -> backing", "frontUS = tooClose", "cmd = backRight, timerCmd = delay")
                .on("driving -> waiting", "frontUS = tooClose", "cmd = stop")
                .on("waiting -> driving", "frontUS = clear", "cmd = fwd")
                .on("backing -> remote", "timerSig = alert", "cmd = stop")
                .on("remote -> returning", "frontUS = clear", "cmd = fwd")
                .build();
    }

    public static Component figure6(Completion completion, boolean total) {
        ComponentBuilder builder = figure5Ports("AvoidCrash6").in(LINE, "ls");
        builder = total ? builder.totalIn(BOOLEAN, "gotCoffee") : builder.in(BOOLEAN, "gotCoffee");
        return builder.automaton(completion, "driving", "backing", "waiting", "remote", "returning")
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

    private static ComponentBuilder figure5Ports(String name) {
        return component(name)
                .in(DISTANCE, "frontUS")
                .in(SIGNAL, "timerSig")
                .out(MOTOR, "cmd")
                .out(COMMAND, "timerCmd");
    }
}
