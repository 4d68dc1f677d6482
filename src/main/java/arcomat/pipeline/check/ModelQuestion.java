package arcomat.pipeline.check;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;

import java.util.List;

/** A question about models, of which no code is made; with errors they answer none. */
public interface ModelQuestion<T> extends Task<CheckedAnswer<T>> {
    /** Files and folders, as the user wrote them. */
    List<String> paths();

    /** What of the models the question is about. */
    Asked asked();

    /**
     * The answer of models without errors.
     *
     * @throws WrongUse where the question does not fit the models
     */
    T answer(LoweredModels models, Session session) throws WrongUse;

    @Override
    default CheckedAnswer<T> run(Session session) throws WrongUse {
        return answer(CheckedModels.checkToExamine(paths(), asked(), session), session);
    }

    /** The answer of models that somebody else has read, such as those on a screen. */
    default CheckedAnswer<T> askAbout(LoadedModels models, Session session) throws WrongUse {
        return answer(CheckedModels.checkToExamine(models, asked(), session), session);
    }

    private CheckedAnswer<T> answer(CheckedModels checked, Session session) throws WrongUse {
        return checked.hasErrors()
                ? CheckedAnswer.refused(checked.result())
                : CheckedAnswer.of(checked.result(), answer(checked.lower(session), session));
    }
}
