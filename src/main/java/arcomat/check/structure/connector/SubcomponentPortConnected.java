package arcomat.check.structure.connector;

import arcomat.check.facts.OpenPorts;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.check.law.Profile;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;

/**
 * ARC0109: the ports of a part are connected. Of a total input, and before code is made of every
 * input, other laws take care. (Hab16 CV6)
 */
public final class SubcomponentPortConnected implements Check.OnOpenPorts {

    @Override
    public void check(
            InstanceSymbol part, List<PortSymbol> open, Context context, Findings findings) {
        if (context.profile() == Profile.REQUIREMENTS) {
            List<String> inputs = OpenPorts.inputs(open);
            report("input", inputs, "receives nothing", "receive nothing", part, findings);
        }
        List<String> outputs = OpenPorts.outputs(open);
        report("output", outputs, "is read by nobody", "are read by nobody", part, findings);
    }

    private static void report(
            String kind,
            List<String> ports,
            String one,
            String several,
            InstanceSymbol part,
            Findings findings) {
        if (!ports.isEmpty()) {
            boolean single = ports.size() == 1;
            findings.report(
                    part.nameSpan(),
                    "%s %s of '%s' %s; connect %s",
                    single ? kind : kind + "s",
                    Wording.quoted(ports),
                    part.name(),
                    single ? one : several,
                    single ? "it" : "them");
        }
    }
}
