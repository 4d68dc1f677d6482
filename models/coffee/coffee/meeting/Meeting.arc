package coffee.meeting;

import coffee.fig6.AvoidCrash;
import coffee.parts.Timer;
import coffee.types.Types.*;

/**
 * Fig. 1 as a closed system: two fetchers meet on a line. It has no inputs, so a simulation of it
 * plays the scene by itself.
 */
component Meeting {
    port out MotorCmd emptyCmd, out MotorCmd loadedCmd, out LineStatus emptyLine;

    /** Stands for a cup holder that always feels the same. */
    component Cup(Boolean full) {
        port <<total>> out Boolean gotCoffee;

        automaton {
            state holding;

            initial holding / {gotCoffee = full};

            holding / {gotCoffee = full};
        }
    }

    component Lane lane;

    // The fetcher without coffee
    component AvoidCrash empty;
    component Timer(2) emptyTimer;
    component Cup(false) noCup;

    // The fetcher with coffee
    component AvoidCrash loaded;
    component Timer(2) loadedTimer;
    component Cup(true) fullCup;

    connect lane.emptyFront -> empty.frontUS;
    connect lane.emptyLine -> empty.ls, emptyLine;
    connect noCup.gotCoffee -> empty.gotCoffee;
    connect empty.timerCmd -> emptyTimer.timerCmd;
    connect emptyTimer.timerSig -> empty.timerSig;
    connect empty.cmd -> lane.emptyCmd, emptyCmd;

    connect lane.loadedFront -> loaded.frontUS;
    connect lane.loadedLine -> loaded.ls;
    connect fullCup.gotCoffee -> loaded.gotCoffee;
    connect loaded.timerCmd -> loadedTimer.timerCmd;
    connect loadedTimer.timerSig -> loaded.timerSig;
    connect loaded.cmd -> lane.loadedCmd, loadedCmd;
}
