package arcomat.check.naming;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class NamingLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0217", new ArraySize()),
                    error("ARC0206", new AutomataNamesUnique()),
                    error("ARC0207", new ComponentNameIsFileName()),
                    warning("ARC0219", new DirectionUnchanged()),
                    error("ARC0213", new FileNamesDifferInCaseOnly()),
                    error("ARC0204", new InitialDeclaredOnce()),
                    error("ARC0215", new InnerComponentNamesUnique()),
                    warning("ARC0216", new InvariantNamesUnique()),
                    error("ARC0214", new JavaClassUnique()).needing(ALL),
                    error("ARC0201", new MemberNamesUnique()),
                    warning("ARC0220", new OneScriptPerName()),
                    error("ARC0208", new PackageIsFolder()),
                    warning("ARC0221", new PackageWritten()),
                    warning("ARC0210", new PortNameUncapitalised()),
                    error("ARC0203", new StateDeclaredOnce()),
                    warning("ARC0211", new StateNamesCapitalisedAlike()).needing(ALL),
                    warning("ARC0209", new TypeNameCapitalised()),
                    warning("ARC0218", new TypeParameterHidden()),
                    error("ARC0202", new TypeParametersUnique()),
                    error("ARC0212", new VariableDeclaredOnce()),
                    error("ARC0205", new VariableUnlikePort()));

    private NamingLaws() {}
}
