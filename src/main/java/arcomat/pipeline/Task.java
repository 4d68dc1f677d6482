package arcomat.pipeline;

/**
 * Something that is asked for: a record of what is wanted, which knows how it is done.
 *
 * @param <R> what comes of it
 */
@FunctionalInterface
public interface Task<R> {
    /**
     * Does the work; whoever asks goes through {@link Session#run}.
     *
     * @throws WrongUse where what is asked for does not fit what is there
     */
    R run(Session session) throws WrongUse;
}
