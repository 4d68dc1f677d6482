package arcomat.benchmarks.step;

import coffee.fig6.logic.AvoidCrash;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.ToIntFunction;

/**
 * Runs a stream through each contestant. What they sent is folded into one number, so that it is
 * used, and so that contestants can be compared.
 */
final class Contestants {
    /** Every contestant from its start, by name. */
    static final Map<String, ToIntFunction<Letters>> ALL = new LinkedHashMap<>();

    static {
        ALL.put("generated", letters -> run(new AvoidCrash(), letters));
        ALL.put("intSwitch", letters -> run(new IntSwitch(), letters));
        ALL.put("enumSwitch", letters -> run(new EnumSwitch(), new EnumLetters(letters)));
        ALL.put("stateless4j", letters -> run(new StatelessMachine(), letters));
        ALL.put("squirrel", letters -> run(new SquirrelMachine(), letters));
        ALL.put("spring", letters -> run(new SpringMachine(), letters));
        ALL.put("scxml", letters -> run(new ScxmlMachine(), letters));
    }

    private Contestants() {}

    static int run(AvoidCrash machine, Letters letters) {
        int sum = 0;
        for (int slice = 0; slice < Letters.COUNT; slice++) {
            machine.frontUS = letters.frontUS[slice];
            machine.timerSig = letters.timerSig[slice];
            machine.ls = letters.ls[slice];
            machine.gotCoffee = letters.gotCoffee[slice];
            machine.step();
            sum = sum * 31 + machine.cmd * 4 + machine.timerCmd;
        }
        return sum;
    }

    static int run(IntSwitch machine, Letters letters) {
        int sum = 0;
        for (int slice = 0; slice < Letters.COUNT; slice++) {
            machine.frontUS = letters.frontUS[slice];
            machine.timerSig = letters.timerSig[slice];
            machine.ls = letters.ls[slice];
            machine.gotCoffee = letters.gotCoffee[slice];
            machine.step();
            sum = sum * 31 + machine.cmd * 4 + machine.timerCmd;
        }
        return sum;
    }

    static int run(EnumSwitch machine, EnumLetters letters) {
        int sum = 0;
        for (int slice = 0; slice < Letters.COUNT; slice++) {
            machine.frontUS = letters.frontUS[slice];
            machine.timerSig = letters.timerSig[slice];
            machine.ls = letters.ls[slice];
            machine.gotCoffee = letters.gotCoffee[slice];
            machine.step();
            sum = sum * 31 + code(machine.cmd) * 4 + code(machine.timerCmd);
        }
        return sum;
    }

    private static int code(Enum<?> message) {
        return message == null ? 0 : message.ordinal() + 1;
    }

    static int run(LibraryMachine machine, Letters letters) {
        int sum = 0;
        for (int slice = 0; slice < Letters.COUNT; slice++) {
            machine.step(letters.code(slice));
            sum = sum * 31 + machine.cmd * 4 + machine.timerCmd;
        }
        return sum;
    }
}
