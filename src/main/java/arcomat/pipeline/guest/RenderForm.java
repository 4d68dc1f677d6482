package arcomat.pipeline.guest;

import arcomat.check.guest.GuestThread;
import arcomat.guest.ReportForm;
import arcomat.guest.host.Guests.Form;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.report.finding.Reported;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;

/**
 * Has a guest write results in its form.
 *
 * @param name of the form, one that is there
 * @param command that found them
 */
public record RenderForm(String name, String command, List<Reported> results)
        implements Task<RenderForm.Rendered> {
    /** A report is a page for each finding at most. */
    private static final Duration LIMIT = Duration.ofSeconds(10);

    /**
     * What came of it.
     *
     * @param text of the report; absent where its guest has failed
     * @param problem why there is none, and what to do; else empty
     */
    public record Rendered(Optional<String> text, String problem) {}

    /** Names of the forms that guests have brought. */
    public static List<String> known(Session session) {
        return session.guests().forms().stream().map(Form::name).toList();
    }

    /**
     * @throws WrongUse where there is no such form
     */
    @Override
    public Rendered run(Session session) throws WrongUse {
        for (Form form : session.guests().forms()) {
            if (form.name().equals(name)) {
                return rendered(form);
            }
        }
        throw new WrongUse("there is no format '%s'", name);
    }

    private Rendered rendered(Form form) {
        ReportForm.Results all =
                new ReportForm.Results(command, results.stream().map(RenderForm::result).toList());
        try {
            return new Rendered(
                    Optional.of(
                            new GuestThread(form.guest(), LIMIT)
                                    .call(
                                            () ->
                                                    Objects.requireNonNull(
                                                            form.form().render(all), "no text"))),
                    "");
        } catch (ExecutionException e) {
            return failed(form, String.valueOf(e.getCause()));
        } catch (TimeoutException e) {
            return failed(form, "not done after " + LIMIT.toSeconds() + " s");
        }
    }

    private Rendered failed(Form form, String reason) {
        return new Rendered(
                Optional.empty(),
                "guest '%s' could not write its report '%s': %s; tell who wrote it, or take another format"
                        .formatted(form.guest(), name, reason));
    }

    private static ReportForm.Result result(Reported each) {
        return new ReportForm.Result(
                each.finding(),
                switch (each.standing()) {
                    case NEW -> ReportForm.Standing.NEW;
                    case SUPPRESSED -> ReportForm.Standing.SUPPRESSED;
                    case KNOWN -> ReportForm.Standing.KNOWN;
                },
                each.reason(),
                each.steps().stream()
                        .map(step -> new ReportForm.Step(step.text(), step.place()))
                        .toList());
    }
}
