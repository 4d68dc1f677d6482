pluginManagement {
    repositories {
        mavenLocal() // where Arcomat's own build puts it, with ./gradlew publishToMavenLocal
        gradlePluginPortal()
    }
}

rootProject.name = '${name}'
