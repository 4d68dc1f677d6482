package arcomat.benchmarks.step;

/** The same stream for whoever takes enums. */
final class EnumLetters {
    final EnumSwitch.Distance[] frontUS = new EnumSwitch.Distance[Letters.COUNT];
    final EnumSwitch.TimerSignal[] timerSig = new EnumSwitch.TimerSignal[Letters.COUNT];
    final EnumSwitch.LineStatus[] ls = new EnumSwitch.LineStatus[Letters.COUNT];
    final Boolean[] gotCoffee = new Boolean[Letters.COUNT];

    EnumLetters(Letters letters) {
        for (int slice = 0; slice < Letters.COUNT; slice++) {
            frontUS[slice] = message(EnumSwitch.Distance.values(), letters.frontUS[slice]);
            timerSig[slice] = message(EnumSwitch.TimerSignal.values(), letters.timerSig[slice]);
            ls[slice] = message(EnumSwitch.LineStatus.values(), letters.ls[slice]);
            gotCoffee[slice] = letters.gotCoffee[slice];
        }
    }

    private static <T> T message(T[] constants, int code) {
        return code == 0 ? null : constants[code - 1];
    }
}
