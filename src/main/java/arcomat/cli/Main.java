package arcomat.cli;

/** Entry point of the command {@code arcomat}. */
public final class Main {
    private Main() {}

    public static void main(String[] args) {
        System.exit(Cli.run(args, Console.ofProcess()));
    }
}
