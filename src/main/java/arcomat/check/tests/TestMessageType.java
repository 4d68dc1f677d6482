package arcomat.check.tests;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.StreamTestSymbol.StreamSymbol;
import arcomat.symbols.expressions.Typed;

/** ARC0703: the messages of a stream have the type of its port. */
public final class TestMessageType implements Check.OnStreamTest {

    @Override
    public Law law() {
        return Law.error("ARC0703");
    }

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        for (StreamSymbol stream : test.streams()) {
            for (Typed message : stream.messages()) {
                if (!message.isAssignableTo(stream.type())) {
                    findings.report(
                            message.expression().node(),
                            "port '"
                                    + stream.node().port()
                                    + "' takes "
                                    + Wording.mismatch(stream.type(), message));
                }
            }
        }
    }
}
