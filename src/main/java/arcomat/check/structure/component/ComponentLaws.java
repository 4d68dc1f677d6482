package arcomat.check.structure.component;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.executableError;
import static arcomat.check.law.Law.warning;
import static arcomat.check.law.Law.warningThenError;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class ComponentLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0117", new ArgumentCount()),
                    error("ARC0134", new ArgumentNamesParameter()).needing(NAMES),
                    error("ARC0118", new ArgumentType()),
                    error("ARC0133", new BehaviourLanguageKnown()),
                    executableError("ARC0125", new BehaviourPresent()).needing(ALL),
                    error("ARC0130", new ClauseUnique()),
                    error("ARC0128", new ComponentVariableConstant()).needing(ALL),
                    error("ARC0143", new ComputationAlone()).needing(ALL),
                    error("ARC0119", new DefaultParametersLast()),
                    error("ARC0140", new FieldOfOneAutomaton()),
                    error("ARC0141", new FieldReadEarly()),
                    error("ARC0113", new InheritanceAcyclic()),
                    error("ARC0148", new InheritedParameterUnchanged()),
                    error("ARC0114", new InheritedPortUnchanged()),
                    warning("ARC0132", new InvariantUnevaluated()).needing(ALL),
                    warningThenError("ARC0127", new JavaPartUnsupported()),
                    error("ARC0142", new PartNeedsKeyword()),
                    error("ARC0131", new PartsCountable()),
                    error("ARC0129", new ProfilesNotMixed()).needing(ALL),
                    executableError("ARC0126", new SingleAutomaton()),
                    error("ARC0112", new SubcomponentAcyclic()),
                    error("ARC0135", new SuperArgumentsSmall()),
                    error("ARC0146", new TimedBehaviour()),
                    error("ARC0101", new TopLevelComponentWithoutInstance()));

    private ComponentLaws() {}
}
