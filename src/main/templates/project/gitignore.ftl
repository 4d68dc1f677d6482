/build/
/.gradle/
