#!/bin/sh
#
# Starts Gradle for this project: ./gradlew TASK...
#
# This script is ours, not the one that Gradle generates. That one needs gradle-wrapper.jar, and this repository
# holds no binaries: nobody can read a jar in a review. What it does instead:
#
#   1. It finds a JDK 17 or newer: JAVA_HOME, then java on the PATH, then Debian's folder of JDK 17.
#   2. It runs the gradle on the PATH if that runs on the JDK: 7.3 or newer, or Debian's 4.4.1, patched to do so.
#   3. Otherwise it downloads the distribution named in gradle/wrapper/gradle-wrapper.properties (IDEs read the
#      same file), or for a JDK too new for that in gradle-wrapper-jdk22.properties, once, checks its SHA-256 before
#      anything of it runs, and keeps it under the Gradle user home.
#   4. If that cannot be had, or does not run on the JDK: as root on Debian or Ubuntu it installs their packages,
#      anywhere else it says what to type.
#
# All arguments go to Gradle as they are, and Gradle looks for the project in the current directory, as it does
# with the generated script.

set -eu

say() { printf 'gradlew: %s\n' "$*" >&2; }
die() { say "$@"; exit 1; }
has() { command -v "$1" >/dev/null 2>&1; }

# Prints the real path of folder $1. Physical, since in '/bin/..' the folder /bin may be a link.
folder() { CDPATH='' cd -P -- "$1" && pwd; }

# Follows the links from file $1 and prints where they end.
resolve() {
    file=$1
    while [ -h "$file" ]; do
        link=$(readlink "$file")
        case $link in
            /*) file=$link ;;
            *) file=$(dirname "$file")/$link ;;
        esac
    done
    printf '%s\n' "$file"
}

# ---- the JDK -----------------------------------------------------------------------------------

# Sets java_home and java_version if $1 is the java of a JDK 17 or newer. The JVM is asked, which takes 30 ms:
# on a PATH there may be a version manager's script, or a stub.
try_java() {
    has "$1" || return 1
    facts=$("$1" -XshowSettings:properties -version 2>&1) || return 1
    java_home=$(printf '%s\n' "$facts" | sed -n 's/^ *java\.home = //p')
    java_version=$(printf '%s\n' "$facts" | sed -n 's/^ *java\.specification\.version = //p')
    case $java_version in
        '' | *[!0-9]*) return 1 ;;                        # Java 8 calls itself 1.8
    esac
    [ "$java_version" -ge 17 ] && [ -x "$java_home/bin/javac" ]
}

find_jdk() {
    if [ -n "${JAVA_HOME:-}" ]; then
        try_java "$JAVA_HOME/bin/java" && return
        say "JAVA_HOME is not a JDK 17 or newer, looking elsewhere: $JAVA_HOME"
    fi
    for java in java /usr/lib/jvm/java-17-openjdk-*/bin/java; do
        try_java "$java" && return
    done
    say 'there is no JDK 17 or newer in JAVA_HOME or on the PATH.'
    java_home='' java_version=0
    return 1
}

# ---- which Gradle runs on it -------------------------------------------------------------------

# Does Gradle $1 run on the JDK found? Compatibility matrix of Gradle's user guide, as of 9.9: the first version
# (major * 100 + minor) that runs on that JDK. No limit is known for what comes after.
fits_jdk() {
    minor=${1#*.}
    newest=0
    for row in 703:17 705:18 706:19 803:20 805:21 808:22 810:23 814:24 901:25 904:26 909:27 910:999; do
        if [ $((${1%%.*} * 100 + ${minor%%[!0-9]*})) -ge "${row%:*}" ]; then newest=${row#*:}; fi
    done
    [ "$java_version" -le "$newest" ]
}

# Does the Gradle whose command is $1 run on the JDK found? Then sets gradle to it, and debian to its folder if it is
# Debian's 4.4.1. The name of a jar tells its version; 'gradle --version' takes most of a second, so only a Gradle with
# no jars beside its command is asked.
installed() {
    gradle=$1 script=$(resolve "$1")
    home=$(folder "$(dirname "$script")/..")
    for jar in "$home"/lib/gradle-core-api-[0-9]*.jar; do :; done
    if [ -f "$jar" ]; then
        gradle=$home/bin/gradle                           # Debian's loses its way when started as /bin/gradle
        release=${jar##*/gradle-core-api-}
        release=${release%.jar}
    else
        release=$(JAVA_HOME=$java_home "$1" --version 2>/dev/null | sed -n 's/^Gradle //p')
    fi
    case $release in
        4.4.1) grep -q -e --add-opens "$script" && debian=$home ;;  # only Debian's has it; it was seen to run on 17, 25
        [0-9]*.[0-9]*) fits_jdk "$release" ;;
        *) return 1 ;;
    esac
}

# ---- the official distribution -----------------------------------------------------------------

property() { sed -n "s/^$1=//p" "$properties" | tr -d '\\\r'; }

# Downloads URL $1 to file $2.
fetch() {
    if has curl; then
        if [ -t 2 ]; then meter=--progress-bar; else meter=-sS; fi
        curl -fL "$meter" --connect-timeout 10 --speed-limit 1000 --speed-time 30 -o "$2" "$1"
    elif has wget; then
        wget -q -O "$2" "$1"                              # all that every wget knows
    else
        say 'there is neither curl nor wget.'
        return 1
    fi
}

sha256() {
    if has sha256sum; then sha256sum <"$1"; else shasum -a 256 <"$1"; fi | cut -d ' ' -f 1
}

# Unpacks the zip $1 in the current folder. jar, which is always there, does not set permissions.
unpack() {
    if has unzip; then unzip -q "$1"; else "$java_home/bin/jar" xf "$1"; fi
}

# Sets gradle to the command of the distribution, which it downloads if need be. False if that cannot be had.
# Called as a condition, so 'set -e' does not watch over it.
distribution() {
    expected=$(property distributionSha256Sum)
    store=${GRADLE_USER_HOME:-$HOME/.gradle}/wrapper/dists/$name
    if [ ! -x "$store/$expected/gradle-$version/bin/gradle" ]; then
        [ -n "$expected" ] || die "$properties names no distributionSha256Sum, and nothing is downloaded unchecked."
        has sha256sum || has shasum || die 'there is neither sha256sum nor shasum to check a download with.'
        work=$store/unfinished.$(date +%s).$$             # beside its final place, so that it can be renamed to it
        { mkdir -p "$store" && mkdir "$work"; } || die "cannot write to $store"
        trap 'rm -rf "$work"' EXIT
        trap 'exit 1' HUP INT TERM
        say "downloading $url"
        if ! fetch "$url" "$work/$name.zip"; then
            rm -rf "$work"
            say "could not download $url"
            return 1
        fi
        actual=$(sha256 "$work/$name.zip")
        if [ "$actual" != "$expected" ]; then
            say "refusing $url: its SHA-256 is not the one in $properties"
            say "expected $expected"
            die "found    $actual"
        fi
        (
            cd "$work" && unpack "$name.zip" && rm "$name.zip" && chmod 755 "gradle-$version/bin/gradle"
        ) || die "could not unpack $name.zip"
        # One rename, so whatever is there is whole. If another gradlew was first, ours lands inside: away with it.
        mv "$work" "$store/$expected" || die "cannot write to $store"
        rm -rf "$store/$expected"/unfinished.*
        trap - EXIT HUP INT TERM
    fi
    gradle=$store/$expected/gradle-$version/bin/gradle
}

# ---- the packages of Debian and Ubuntu ---------------------------------------------------------

is_debian() { [ -f /etc/debian_version ] && has apt-get; }

# Prints the packages that are missing. Releases that no longer have JDK 17 have a newer one as their default.
packages() {
    if [ "$java_version" -gt 0 ]; then
        echo gradle
    elif apt-cache show openjdk-17-jdk-headless >/dev/null 2>&1; then
        echo gradle openjdk-17-jdk-headless
    else
        echo gradle default-jdk-headless
    fi
}

install_packages() {
    say 'installing packages, as root: apt-get update'
    apt-get update -q >&2 || die 'apt-get update failed.'
    wanted=$(packages)
    say "installing packages, as root: apt-get install -y $wanted"
    # shellcheck disable=SC2086 # one argument for each package
    DEBIAN_FRONTEND=noninteractive apt-get install -q -y $wanted >&2 || die "apt-get install -y $wanted failed."
    find_jdk || die "apt-get has installed $wanted without success."
    installed /usr/bin/gradle || die "the gradle that apt-get installed does not run on JDK $java_version."
}

say_what_to_type() {
    say 'what to type, then gradlew again:'
    if is_debian; then
        say "  sudo apt-get update && sudo apt-get install -y $(packages)"
    else
        if [ "$java_version" = 0 ]; then say '  export JAVA_HOME=FOLDER           # of a JDK 17 or newer'; fi
        say "  export PATH=\"FOLDER/bin:\$PATH\"   # of a Gradle 7.3 or newer that runs on the JDK"
    fi
    exit 1
}

# ---- in this order -----------------------------------------------------------------------------

wrapper=$(folder "$(dirname "$(resolve "$0")")")/gradle/wrapper

# Reads the name of the distribution from the properties file $1.
choose() {
    properties=$wrapper/$1
    url=$(property distributionUrl)
    name=${url##*/}
    name=${name%.zip}                                     # gradle-8.6-bin
    version=${name#gradle-}
    version=${version%-*}                                 # 8.6
}

debian=''                                                 # the folder of Debian's Gradle, where that is used

# Sets gradle to one that runs on the JDK found. False, having said why, if there is none.
find_gradle() {
    if has gradle && installed "$(command -v gradle)"; then return; fi
    choose gradle-wrapper.properties
    if ! fits_jdk "$version"; then choose gradle-wrapper-jdk22.properties; fi
    if fits_jdk "$version"; then
        distribution
    else
        say "no gradle on the PATH runs on JDK $java_version, and $name does not either."
        return 1
    fi
}

if ! { find_jdk && find_gradle; }; then
    if is_debian && [ "$(id -u)" = 0 ]; then install_packages; else say_what_to_type; fi
fi

# ---- the locale --------------------------------------------------------------------------------

# Java reads the names of files by the locale: in one of ASCII alone (LANG unset, LC_ALL=C) it cannot open a file with
# an accent in its name, and Gradle does not start below such a folder. Then the first UTF-8 locale there is is taken.
if has locale; then
    case $(locale charmap 2>/dev/null) in
        ANSI_X3.4-1968 | US-ASCII | '')
            for utf8 in C.UTF-8 en_US.UTF-8 C.utf8; do
                if [ "$(LC_ALL=$utf8 locale charmap 2>/dev/null)" = UTF-8 ]; then
                    LC_ALL=$utf8
                    export LC_ALL
                    break
                fi
            done ;;
    esac
fi

JAVA_HOME=$java_home
export JAVA_HOME
if [ -n "$debian" ]; then
    # What Debian's script does, but for the three lines of the JVM's version that it prints every time. The options
    # are split by shell quoting, as there.
    quiet=''
    case $java_version in
        24 | 25) quiet=--sun-misc-unsafe-memory-access=allow ;;   # otherwise they warn of Gradle's own Guava
    esac
    eval "set -- --add-opens java.base/java.lang=ALL-UNNAMED $quiet ${JAVA_OPTS:-} ${GRADLE_OPTS:-}" \
        '-Dorg.gradle.appname=gradle -classpath "$debian/lib/gradle-launcher-4.4.1.jar"' \
        'org.gradle.launcher.GradleMain "$@"'
    gradle=$java_home/bin/java
fi
exec "$gradle" "$@"
