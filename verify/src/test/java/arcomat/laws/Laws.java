package arcomat.laws;

import java.util.List;

/** All laws. */
final class Laws {
    static final List<Law> ALL =
            List.of(
                    new AsTheReference(),
                    new RunsAreAllowed(),
                    new CounterexamplesAreForbidden(),
                    new RefinementIsAnOrder(),
                    new ContextsKeepRefinement(),
                    new CertificatesProve(),
                    new AllAutomataTogether(),
                    new DifferenceIsBothWays(),
                    new ControllersKeepAll(),
                    new TestsPassOnTheirModel(),
                    new MistakesAreToldOrNamed(),
                    new DeadIsNeverTaken(),
                    new EnginesAgree(),
                    new MonaAgrees(),
                    new InvariantsAsTheReference(),
                    new CertificatesProve.OfInvariants(),
                    new WhyNothingFired(),
                    new MapsAsDefined(),
                    new ConfigurationsAsByHand(),
                    new FirstRowDecides(),
                    new ExpressionsAreTaken());

    private Laws() {}
}
