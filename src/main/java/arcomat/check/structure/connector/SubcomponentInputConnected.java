package arcomat.check.structure.connector;

import arcomat.check.facts.OpenPorts;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;

/** ARC0110: before code is made, each input of a part has a sender. */
public final class SubcomponentInputConnected implements Check.OnOpenPorts {

    @Override
    public void check(
            InstanceSymbol part, List<PortSymbol> open, Context context, Findings findings) {
        List<String> inputs = OpenPorts.inputs(open);
        if (!inputs.isEmpty()) {
            boolean single = inputs.size() == 1;
            findings.report(
                    part.nameSpan(),
                    "%s %s of '%s' %s no sender; code needs to know what arrives there",
                    single ? "input" : "inputs",
                    Wording.quoted(inputs),
                    part.name(),
                    single ? "has" : "have");
        }
    }
}
