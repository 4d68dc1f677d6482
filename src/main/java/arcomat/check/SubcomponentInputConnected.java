package arcomat.check;

import arcomat.symbols.InstanceSymbol;

import java.util.List;

/** ARC0110: before code is made, each input of a part has a sender. */
final class SubcomponentInputConnected implements Check.OnInstance {

    @Override
    public Law law() {
        return Law.executableError("ARC0110");
    }

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        List<String> inputs =
                OpenPorts.names(OpenPorts.of(instance), p -> p.isInput() && !p.isTotal());
        if (!inputs.isEmpty()) {
            boolean single = inputs.size() == 1;
            findings.report(
                    instance.nameSpan(),
                    (single ? "input " : "inputs ")
                            + Wording.quoted(inputs)
                            + " of '"
                            + instance.name()
                            + "' "
                            + (single ? "has" : "have")
                            + " no sender; code needs to know what arrives there");
        }
    }
}
