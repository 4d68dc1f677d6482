package arcomat.pipeline.compile;

/** A model that only the interpreter can run: no Java virtual machine holds its code. */
public final class TooLargeToCompile extends RuntimeException {
    TooLargeToCompile(String message) {
        super(message);
    }
}
