package arcomat.check.structure.connector;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.executableError;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class ConnectorLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0145", new ConnectedArraysFit()).needing(NAMES),
                    error("ARC0105", new ConnectorDirection()).needing(NAMES),
                    error("ARC0103", new ConnectorEndExists()).needing(NAMES),
                    error("ARC0102", new ConnectorEndForm()),
                    error("ARC0106", new ConnectorTypes()),
                    error("ARC0124", new DelayInCycle()).needing(ALL),
                    warning("ARC0108", new OwnPortConnected()).needing(ALL),
                    error("ARC0107", new PortConnectedToItself()),
                    error("ARC0104", new PortUniqueSender()),
                    executableError("ARC0110", new SubcomponentInputConnected()).needing(ALL),
                    warning("ARC0109", new SubcomponentPortConnected()).needing(ALL));

    private ConnectorLaws() {}
}
